# What Gappa proves of the core's arithmetic: README.md. Each proof is run once with the headers' bounds, and once with a bound that is
# false, which must not be proved.
add_executable(print_numbers ${CMAKE_CURRENT_LIST_DIR}/print_numbers.cpp)
target_link_libraries(print_numbers PRIVATE shade16::core shade16_warnings)
if(TARGET checks)
  add_dependencies(checks print_numbers)
endif()

function(shade16_run_proof test file tier claim)
  shade16_add_script_test(proof.${test} LABEL proof SCRIPT proof/run_proof.cmake NUMBERS=$<TARGET_FILE:print_numbers>
    PROOF=${CMAKE_CURRENT_SOURCE_DIR}/proof/${file}.gappa.in TIER=${tier} CLAIM=${claim} SCRATCH=${CMAKE_CURRENT_BINARY_DIR}/proof)
endfunction()

# shade16_add_proof(<name> <tier>): proof/<name>.gappa.in with the numbers of a tier. Half of the claim must fail.
function(shade16_add_proof name tier)
  shade16_run_proof(${name}.${tier} ${name} ${tier} full)
  shade16_run_proof(${name}.${tier}.half_of_the_bound_is_not_proved ${name} ${tier} half)
endfunction()

shade16_add_proof(multiply highp)
shade16_add_proof(newton_step highp)
shade16_add_proof(reciprocal highp)
foreach(tier IN ITEMS lowp mediump highp)
  shade16_add_proof(light_term ${tier})
  shade16_add_proof(color_sum ${tier})
endforeach()

# run_proof.cmake itself: what it must not take for a proof, or for a refutation.
function(shade16_refuses_proof file claim sentence)
  shade16_run_proof(self_test.${file} self_test/${file} highp ${claim})
  set_tests_properties(proof.self_test.${file} PROPERTIES PASS_REGULAR_EXPRESSION "${sentence}")
endfunction()

shade16_refuses_proof(mistake half "syntax error")
shade16_refuses_proof(wrong_rule full "are not trivially equal")
shade16_refuses_proof(unknown_number full "prints no such number")
