# SPDX-License-Identifier: MIT
# Options and libraries of every shd target.

# The SIMD targets of each value of SHD_SIMD. Highway's HWY_DISABLED_TARGETS excludes all others. Kernels
# hold vectors in structs, which scalable vectors (SVE, RVV) do not allow. The other targets that are left out (AVX3_DL,
# AVX3_ZEN4, AVX3_SPR, AVX10, NEON_WITHOUT_AES and more) would double the size of the library without new instructions
# for its kernels. core/simd_target.cpp refuses to compile for a target that is in no list.
set(shd_simd_baseline HWY_SCALAR HWY_EMU128 "(1LL<<14)" HWY_NEON HWY_WASM)  # the bit is HWY_SSE2, new after Highway 1.0.3
set(shd_simd_few ${shd_simd_baseline} HWY_AVX2)
set(shd_simd_auto ${shd_simd_few} HWY_SSE4 HWY_AVX3)
set(shd_simd_all ${shd_simd_auto} HWY_SSSE3)

# Warnings, sanitizers and the flags that keep the bits the same everywhere.
function(shd_compile_options target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wshadow -Wpedantic
    $<$<BOOL:${SHD_WERROR}>:-Werror>
    # One rounding per operation on every target: a fused multiply-add would change the bits.
    -ffp-contract=off
    -fno-math-errno
    $<$<COMPILE_LANGUAGE:CXX>:-fvisibility-inlines-hidden>
    # A project without a build type, which includes shd, gets a fast library too.
    "$<$<CONFIG:>:-O2;-DNDEBUG>")
  set_target_properties(${target} PROPERTIES
    C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden POSITION_INDEPENDENT_CODE ON)
  if(SHD_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${SHD_SANITIZE} -fno-omit-frame-pointer
                           -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${SHD_SANITIZE})
  endif()
  if(SHD_FUZZ)
    # Coverage that guides libFuzzer. Inputs are lists of choices, so operands of comparisons are no use as inputs, and
    # tracing them takes a third of the time.
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp)
  endif()
  if(SHD_SIMD STREQUAL "scalar")
    target_compile_definitions(${target} PRIVATE HWY_COMPILE_ONLY_SCALAR)
  elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
    # One target, NEON, which is in the baseline of 64-bit ARM. With the second macro Highway leaves out the attributes
    # of targets that are chosen at run time, because gcc does not apply them to lambdas and implicit constructors.
    target_compile_definitions(${target} PRIVATE HWY_COMPILE_ONLY_STATIC TOOLCHAIN_MISS_SYS_AUXV_H)
  elseif(EMSCRIPTEN)
    target_compile_definitions(${target} PRIVATE HWY_COMPILE_ONLY_STATIC)  # one target, WASM with -msimd128
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)  # addresses through a table are slow
  else()
    string(JOIN "|" kept ${shd_simd_${SHD_SIMD}})
    target_compile_definitions(${target} PRIVATE "HWY_DISABLED_TARGETS=(~(${kept}))")
  endif()
endfunction()

# Sources that are compiled once per SIMD target, under sanitizers: each vector is a stack variable there, and with
# these checks one file took gcc 12 more than eight minutes instead of one. Wild and null accesses are still the
# address sanitizer's; every other source keeps every check.
function(shd_kernel_options)
  if(NOT SHD_SANITIZE)
    return()
  endif()
  foreach(source IN LISTS ARGN)
    file(STRINGS ${source} kernel REGEX "hwy/foreach_target.h")
    if(kernel)
      set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS
        "-fno-sanitize=null,alignment,object-size;-fno-sanitize-address-use-after-scope;$<$<CXX_COMPILER_ID:GNU>:-fno-var-tracking>")
    endif()
  endforeach()
endfunction()

# Joins kernels of a folder in units of up to four, because Highway's headers take two seconds of each unit, once per SIMD
# target. Folders of long kernels, and of those whose speed depends on what the compiler puts inline, are not joined.
set(shd_joined_folders procedural light environment occlusion shade geometry texture/domain texture/filter)
set(shd_kernels_apart "shade/(illuminate|surround)"
    "texture/filter/(anisotropic|bicubic|bilinear|directions|slices|stochastic|summed_area|trilinear)")
function(shd_join_kernels sources)
  if(NOT SHD_UNITY)
    return()
  endif()
  list(JOIN shd_kernels_apart "|" apart)
  foreach(folder IN LISTS shd_joined_folders)
    set(kernels "")
    foreach(source IN LISTS ${sources})
      file(RELATIVE_PATH path ${CMAKE_CURRENT_SOURCE_DIR} ${source})
      file(STRINGS ${source} kernel REGEX "hwy/foreach_target.h")
      if(kernel AND path MATCHES "^${folder}/[a-z_0-9]+\\.cpp$" AND NOT path MATCHES "^(${apart})")
        list(APPEND kernels ${path})
        list(REMOVE_ITEM ${sources} ${source})
      endif()
    endforeach()
    string(REPLACE "/" "_" name ${folder})
    set(unit 0)
    while(kernels)
      list(SUBLIST kernels 0 4 part)
      list(REMOVE_ITEM kernels ${part})
      math(EXPR unit "${unit} + 1")
      set(file kernels/${name}_${unit}.cpp)
      # Each kernel names itself for Highway; the unit does it before the first one, and again for the next target.
      set(itself "#undef HWY_TARGET_INCLUDE\n#define HWY_TARGET_INCLUDE \"${file}\"\n")
      list(TRANSFORM part REPLACE "(.+)" "#include \"\\1\"\n")
      list(JOIN part "" includes)
      file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${file} CONTENT "${itself}#include <hwy/foreach_target.h>\n\n${includes}\n${itself}" @ONLY)
      list(APPEND ${sources} ${CMAKE_CURRENT_BINARY_DIR}/${file})
    endwhile()
  endforeach()
  set(${sources} ${${sources}} PARENT_SCOPE)
endfunction()

# test, target that builds it, labels: tests/run.sh chooses tests by their labels, and tests_<label> builds them.
function(shd_label test target)
  set_property(TEST ${test} APPEND PROPERTY LABELS ${ARGN})
  foreach(label IN LISTS ARGN)
    if(NOT TARGET tests_${label})
      add_custom_target(tests_${label})
    endif()
    add_dependencies(tests_${label} ${target})
  endforeach()
endfunction()

# Compiles the sources of each folder together, except kernels, which are compiled once per SIMD target, and sources with
# definitions or options of their own. Local names are unique in a folder.
function(shd_unity target)
  if(NOT SHD_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(path ${source} ABSOLUTE)
    if(NOT path MATCHES "\\.cpp$" OR NOT EXISTS ${path})
      continue()
    endif()
    file(STRINGS ${path} kernel REGEX "hwy/foreach_target.h")
    get_source_file_property(definitions ${source} COMPILE_DEFINITIONS)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/src ${path}/..)
    if(NOT kernel AND NOT definitions)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# A library: `name` from the object libraries `objects`, exporting what `map` lists.
function(shd_library name objects map export_name)
  list(TRANSFORM objects REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
  if(SHD_BUILD_SHARED)
    add_library(${name} SHARED ${objects})
  else()
    add_library(${name} STATIC ${objects})
  endif()
  add_library(shd::${export_name} ALIAS ${name})
  target_sources(${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${ARGN})
  target_compile_features(${name} INTERFACE c_std_99)
  set_target_properties(${name} PROPERTIES
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    EXPORT_NAME ${export_name}
    LINKER_LANGUAGE CXX
    LINK_DEPENDS ${map})
  if(NOT name STREQUAL "shd" AND NOT CMAKE_INSTALL_RPATH)
    # A component finds libshd beside it, also for a program whose own search path the loader does not pass on.
    set_target_properties(${name} PROPERTIES INSTALL_RPATH "$<IF:$<PLATFORM_ID:Darwin>,@loader_path,$ORIGIN>")
  endif()
  if(SHD_SANITIZE)
    target_link_options(${name} PUBLIC -fsanitize=${SHD_SANITIZE})
  endif()
  get_target_property(type ${name} TYPE)
  if(type STREQUAL "SHARED_LIBRARY" AND NOT WIN32 AND NOT APPLE)
    target_link_options(${name} PRIVATE -Wl,--version-script=${map})
    if(NOT SHD_SANITIZE)
      target_link_options(${name} PRIVATE -Wl,--no-undefined)
    endif()
  endif()
endfunction()
