# What every test that boots Debian's kernel needs; absent, it is skipped with the reason.
include(${CMAKE_CURRENT_LIST_DIR}/../../scripts/skip.cmake)

foreach(program IN ITEMS qemu-system-x86_64 busybox cpio gzip strip timeout)
  shade16_skip_without_program(${program})
endforeach()
if(NOT PROGRAM)
  shade16_skip("Either libgpiod-dev, with libgpiod.a, was not installed when this was configured, or this is a sanitizer's build.")
endif()
shade16_skip_without_file(${KERNEL}/version "scripts/guest.sh fetches Debian's kernel and builds its modules.")
