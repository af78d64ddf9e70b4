# MRPT's windows and X11, both by choice: users of the installed library need neither.
mrpt_ext_find_mrpt(QUIET gui)
find_package(X11 QUIET)
