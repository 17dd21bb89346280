# What an image must not contain, looked for in the linked file, where only what something reaches is left. Every image that a build of the
# board makes: apps, scenes, kernels, and those that go wrong. Included when all are known.
get_property(images GLOBAL PROPERTY SHADE16_IMAGES)
list(REMOVE_ITEM images rule_breaker)
# The kernels of identity.md make the tables of a shininess that is not known before: that divides 64 bits, and no scene does it.
set(except_identity division_of_64_bits)
foreach(image IN LISTS images)
  get_target_property(left_out ${image} EXCLUDE_FROM_ALL)
  if(NOT left_out)
    shade16_add_script_test(forbidden_symbols.${image} LABEL budget SCRIPT budget/forbidden_symbols.cmake
      NM=${CMAKE_NM} IMAGE=$<TARGET_FILE:${image}> EXCEPT=${except_${image}})
  endif()
endforeach()
