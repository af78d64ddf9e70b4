# MRPT's windows and X11, both by choice: users of the installed library need neither.
find_package(mrpt-gui 2.5 QUIET)
find_package(X11 QUIET)
