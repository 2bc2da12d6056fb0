# SPDX-License-Identifier: MIT
# add_lavapipe(<target>): adds Mesa's lavapipe as a peer and defines SHD_BENCH_LAVAPIPE, where Vulkan and a compiler of
# shaders are installed (Debian packages libvulkan-dev, glslang-tools). The device is looked for at run time
# (mesa-vulkan-drivers).
set(lavapipe_folder ${CMAKE_CURRENT_LIST_DIR})

function(add_lavapipe target)
  find_package(Vulkan QUIET)
  find_program(SHD_GLSLANG NAMES glslangValidator glslang)
  mark_as_advanced(SHD_GLSLANG)
  if(NOT Vulkan_FOUND OR NOT SHD_GLSLANG)
    message(STATUS "${target}: no Vulkan or no glslangValidator (libvulkan-dev, glslang-tools), lavapipe is left out")
    return()
  endif()
  set(shader ${lavapipe_folder}/lavapipe.comp)
  set(headers ${CMAKE_CURRENT_BINARY_DIR}/lavapipe)
  file(MAKE_DIRECTORY ${headers})
  add_custom_command(OUTPUT ${headers}/lavapipe_shader.h ${headers}/lavapipe_implicit.h
    COMMAND ${SHD_GLSLANG} -V --quiet --vn kLavapipeShader -o ${headers}/lavapipe_shader.h ${shader}
    COMMAND ${SHD_GLSLANG} -V --quiet -DIMPLICIT --vn kLavapipeImplicit -o ${headers}/lavapipe_implicit.h ${shader}
    DEPENDS ${shader} VERBATIM)
  target_sources(${target} PRIVATE ${headers}/lavapipe_shader.h ${headers}/lavapipe_implicit.h
                                   ${lavapipe_folder}/lavapipe.cpp ${lavapipe_folder}/gpu_device.cpp
                                   ${lavapipe_folder}/gpu_memory.cpp)
  target_include_directories(${target} PRIVATE ${headers})
  target_compile_definitions(${target} PUBLIC SHD_BENCH_LAVAPIPE)
  target_link_libraries(${target} PRIVATE Vulkan::Vulkan)
endfunction()
