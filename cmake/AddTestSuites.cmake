# ctest includes this file for each GoogleTest program. It adds one test for each test suite of the program. One process
# for each suite instead of one for each test saves a third of the processor time: most tests need a Vulkan device.
# Input: `name`, `program` (the path), `folder` (where the program runs), `results` (the folder for the results of the
# single tests, one XML file for each suite), `timeout_s`, `labels`.
if(NOT EXISTS ${program})
  add_test(${name}_is_not_built ${program})
  return()
endif()
execute_process(COMMAND ${program} --gtest_list_tests WORKING_DIRECTORY ${folder}
                OUTPUT_VARIABLE listed RESULT_VARIABLE failed TIMEOUT 60)
if(failed)
  message(FATAL_ERROR "${program} --gtest_list_tests failed: ${failed}")
endif()
# A suite is a line such as `All/Golden.` that is not indented. The type of a typed suite follows behind a `#`.
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${listed}")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "\\.$" "" suite "${suite}")
  string(REPLACE "/" "_" file "${suite}")
  add_test("${suite}" ${program} "--gtest_filter=${suite}.*" "--gtest_output=xml:${results}/${name}.${file}.xml")
  set_tests_properties("${suite}" PROPERTIES WORKING_DIRECTORY ${folder} TIMEOUT ${timeout_s} LABELS "${labels}")
endforeach()
