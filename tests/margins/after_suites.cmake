# Read by ctest after the lists of all suites: the record of the hard cases is judged when their tests have left their
# figures, whatever runs beside them.
if(margins_list)
  set_tests_properties(${margins_list} PROPERTIES DEPENDS
    "${unit_threaded_list};${unit_list};${stability_threaded_list};${stability_list};${app_list};${ui_list};${gl_egl_list};${gl_osmesa_list};${gl_twins_list}")
endif()
