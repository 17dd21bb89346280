# The C++ tests: one program for all *_test.cpp of a folder, so that adding a test is adding a file.
# `checks` builds every program that ctest runs, and nothing else.
add_custom_target(checks)

find_package(GTest)
if(NOT GTest_FOUND)
  if("$ENV{SHADE16_REQUIRE_ALL}" STREQUAL "1")
    message(FATAL_ERROR "GoogleTest is not installed, and SHADE16_REQUIRE_ALL asks for every test.")
  endif()
  message(STATUS "GoogleTest is not installed: the C++ tests are left out.")
  return()
endif()

# shade16_add_test(<name> <label> <source>...)
function(shade16_add_test name label)
  add_executable(${name} ${ARGN})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE GTest::gtest_main GTest::gmock shade16::core shade16_warnings)
  add_dependencies(checks ${name})
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES TIMEOUT 300 LABELS "${label}")
endfunction()

foreach(group IN ITEMS unit accuracy raster system proof extremes)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${group}/*_test.cpp)
  if(sources)
    shade16_add_test(${group}_tests ${group} ${sources})
  endif()
  list(LENGTH sources source_count)
  if(source_count GREATER 10)  # GoogleTest takes two seconds to read
    target_precompile_headers(${group}_tests PRIVATE <gtest/gtest.h>)
  endif()
endforeach()

# Display drivers against models of their controllers.
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/displays/*_test.cpp)
list(APPEND sources displays/dcs_model.cpp)
shade16_add_test(displays_tests unit ${sources})
target_include_directories(displays_tests PRIVATE ${PROJECT_SOURCE_DIR}/firmware)
target_compile_definitions(displays_tests PRIVATE SHADE16_DOCS="${PROJECT_SOURCE_DIR}/docs")

# What an emulated board's display shows: the model, after what its bus carried.
add_executable(decode_display displays/decode.cpp displays/dcs_model.cpp)
target_include_directories(decode_display PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/firmware)
target_link_libraries(decode_display PRIVATE shade16::core shade16_warnings)
add_dependencies(checks decode_display)

# The chips of boards whose emulators lack what drives the display: each against a model of its registers.
foreach(board_and_chip IN ITEMS "stm32f4_ili9341 stm32f4" "hifive1_st7735 fe310")
  separate_arguments(board_and_chip)
  list(POP_FRONT board_and_chip board chip)
  shade16_add_test(${board}_tests unit chips/${board}_test.cpp chips/${chip}.cpp chips/console_throws.cpp displays/dcs_model.cpp)
  target_include_directories(${board}_tests PRIVATE ${PROJECT_SOURCE_DIR}/firmware ${SHADE16_BOARDS_DIR}/${board})
  target_compile_definitions(${board}_tests PRIVATE SHADE16_DOCS="${PROJECT_SOURCE_DIR}/docs")
endforeach()

shade16_add_test(silent_chips_tests unit chips/silent_chips_test.cpp chips/console_throws.cpp displays/dcs_model.cpp)
target_include_directories(silent_chips_tests PRIVATE ${PROJECT_SOURCE_DIR}/firmware)
target_compile_definitions(silent_chips_tests PRIVATE SHADE16_DOCS="${PROJECT_SOURCE_DIR}/docs")

# Adapters to other libraries, against stubs with their signatures.
shade16_add_test(adapters_tests unit adapters/adapters_test.cpp)
target_include_directories(adapters_tests PRIVATE ${PROJECT_SOURCE_DIR}/firmware ${CMAKE_CURRENT_SOURCE_DIR}/adapters/stubs)

# What must hold for any numbers, where RapidCheck is there to look for those for which it does not.
find_package(rapidcheck QUIET)
if(rapidcheck_FOUND)
  shade16_add_test(properties_tests unit properties/numbers_test.cpp)
  target_link_libraries(properties_tests PRIVATE rapidcheck)
  set_tests_properties(properties_tests PROPERTIES ENVIRONMENT "RC_PARAMS=max_success=2000 seed=1")
elseif("$ENV{SHADE16_REQUIRE_ALL}" STREQUAL "1")
  message(FATAL_ERROR "RapidCheck is not installed, and SHADE16_REQUIRE_ALL asks for every test.")
else()
  message(STATUS "RapidCheck is not installed: the properties are left out.")
endif()

# These compare the engine with the reference, or test the simulator itself.
foreach(group IN ITEMS accuracy system extremes displays stm32f4_ili9341 hifive1_st7735 silent_chips)
  if(TARGET ${group}_tests AND TARGET host_sim_library)
    target_link_libraries(${group}_tests PRIVATE host_sim_library)
  endif()
endforeach()

# What shows frames on this computer, against models of what lies behind the kernel.
if(TARGET screens)
  target_link_libraries(displays_tests PRIVATE screens)
  target_sources(system_tests PRIVATE displays/dcs_model.cpp)
  target_include_directories(system_tests PRIVATE ${PROJECT_SOURCE_DIR}/firmware)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/screen/*_test.cpp)
  shade16_add_test(screen_tests unit ${sources} displays/dcs_model.cpp)
  target_link_libraries(screen_tests PRIVATE screens)
endif()

# Some run the program as its users do.
if(TARGET system_tests AND TARGET shade16)
  target_compile_definitions(system_tests PRIVATE SHADE16_PROGRAM="$<TARGET_FILE:shade16>")
  add_dependencies(system_tests shade16)
endif()

# Some compare with the baked scenes, compiled.
get_property(scenes GLOBAL PROPERTY SHADE16_SCENES)
if(TARGET system_tests AND scenes)
  list(TRANSFORM scenes PREPEND scene_)
  list(GET scenes 0 scene)
  target_compile_definitions(system_tests PRIVATE SHADE16_SCENE_PROGRAMS="$<TARGET_FILE_DIR:${scene}>")
  add_dependencies(system_tests ${scenes})
endif()

# The renderer's own tests by themselves: the sanitizers run them.
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/renderer/*_test.cpp)
shade16_add_test(renderer_tests raster ${sources})
target_link_libraries(renderer_tests PRIVATE host_sim_library)

# Every scene drawn by the smallest of some pipelines and by that of all terms: a program of many pipelines, compiled quickly, not well.
# One compiler and no sanitizer: the pipelines are those that other tests build with both.
if(TARGET host_sim_library AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/pairwise/rows.hpp rows REGEX "^    {")
  list(LENGTH rows row_count)
  math(EXPR last_row "${row_count} + 1")  # and all terms, without depth and with it
  set(objects)
  foreach(row RANGE ${last_row})
    add_library(pairwise_row_${row} OBJECT pairwise/row.cpp)
    target_compile_definitions(pairwise_row_${row} PRIVATE SHADE16_ROW=${row})
    target_include_directories(pairwise_row_${row} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_options(pairwise_row_${row} PRIVATE -O1)
    target_link_libraries(pairwise_row_${row} PRIVATE shade16::core shade16_warnings)
    list(APPEND objects $<TARGET_OBJECTS:pairwise_row_${row}>)
  endforeach()
  shade16_add_test(pairwise_tests system pairwise/pairwise_test.cpp ${objects})
  target_link_libraries(pairwise_tests PRIVATE host_sim_library)
endif()
