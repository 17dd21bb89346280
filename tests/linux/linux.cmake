# The board linux_spi: its lines over stubs of libgpiod 1 and 2, and over the real one and a real kernel in an emulator.
find_package(fmt REQUIRED)
if(COMMAND shade16_add_test)
  foreach(version IN ITEMS 1 2)
    set(stub ${CMAKE_CURRENT_SOURCE_DIR}/linux/stubs_v${version})
    shade16_linux_spi(linux_spi_stub_v${version} ${version})
    target_include_directories(linux_spi_stub_v${version} BEFORE PUBLIC ${stub})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/linux/*_test.cpp)
    shade16_add_test(linux_v${version}_tests "unit;linux" ${sources} ${stub}/gpiod.cpp displays/dcs_model.cpp
                     ${PROJECT_SOURCE_DIR}/host_sim/screen/wired_screen.cpp ${PROJECT_SOURCE_DIR}/host_sim/screen/lasting_screen.cpp)
    target_link_libraries(linux_v${version}_tests PRIVATE linux_spi_stub_v${version})
  endforeach()
endif()

# The program of the guest and this computer's hash of its frame. Linked statically, because the guest has nothing but a shell; a
# sanitizer's programs can not be.
find_library(SHADE16_GPIOD_STATIC NAMES libgpiod.a)
if(SHADE16_GPIOD_VERSION AND SHADE16_GPIOD_STATIC AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  shade16_linux_spi(linux_spi_static ${SHADE16_GPIOD_VERSION} fmt::fmt-header-only)
  add_executable(linux_guest linux/guest/main.cpp linux/guest/on_spidev.cpp linux/guest/watched.cpp displays/dcs_model.cpp)
  target_link_libraries(linux_guest PRIVATE linux_spi_static ${SHADE16_GPIOD_STATIC} shade16_warnings)
  target_link_options(linux_guest PRIVATE -static)
  add_executable(linux_guest_hash linux/guest/hash.cpp)
  target_include_directories(linux_guest_hash PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/firmware)
  target_link_libraries(linux_guest_hash PRIVATE shade16::core shade16_warnings)
  if(TARGET checks)
    add_dependencies(checks linux_guest linux_guest_hash shade16)
  endif()
  set(guest_programs PROGRAM=$<TARGET_FILE:linux_guest> HASH_PROGRAM=$<TARGET_FILE:linux_guest_hash>
      SHADE16=$<TARGET_FILE:shade16> MODEL=${PROJECT_SOURCE_DIR}/assets/teapot.obj)
endif()
shade16_add_script_test(linux.guest LABEL linux SCRIPT linux/guest/check.cmake ${guest_programs} KERNEL=${PROJECT_SOURCE_DIR}/build/guest
                        WORK=${CMAKE_CURRENT_BINARY_DIR}/linux_guest_boot)
set_tests_properties(linux.guest PROPERTIES TIMEOUT 180)
shade16_add_script_test(linux.framebuffer LABEL linux SCRIPT linux/guest/framebuffer_check.cmake ${guest_programs} KERNEL=${PROJECT_SOURCE_DIR}/build/guest
                        WORK=${CMAKE_CURRENT_BINARY_DIR}/linux_framebuffer_boot)
set_tests_properties(linux.framebuffer PROPERTIES TIMEOUT 180)
