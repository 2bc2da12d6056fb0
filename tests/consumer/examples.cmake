# SPDX-License-Identifier: MIT
# The examples as programs of the including project.
find_package(Threads REQUIRED)
foreach(name IN ITEMS hello lookup levels program custom_allocator own_threads frame)
  add_executable(${name} ${EXAMPLES_DIR}/${name}.c)
  target_link_libraries(${name} PRIVATE shd::shd m)
endforeach()
target_link_libraries(own_threads PRIVATE Threads::Threads)
target_sources(frame PRIVATE ${EXAMPLES_DIR}/frame_scene.c)
foreach(component IN LISTS COMPONENTS)
  string(TOUPPER ${component} upper)
  target_compile_definitions(frame PRIVATE EXAMPLE_HAS_${upper})
  target_link_libraries(frame PRIVATE shd::${component})
endforeach()
