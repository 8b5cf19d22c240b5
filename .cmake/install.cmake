# cmake --install: the program, its man page and completion (from its own help), its Python package, campaigns, batch
# scripts, documents.
# Nothing installed needs the source tree. Included by the file at the top.

# Libraries of modules and of spack lie where no loader looks by itself.
set_target_properties(overturn PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
install(TARGETS overturn RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")

# Made when they are installed, so that building the program alone is enough.
set(manual "${PROJECT_BINARY_DIR}/generated/overturn.1")
set(completion "${PROJECT_BINARY_DIR}/generated/overturn.bash")
install(CODE "execute_process(COMMAND bash \"${PROJECT_SOURCE_DIR}/.cmake/manual.sh\" \"$<TARGET_FILE:overturn>\"
                                      \"${PROJECT_VERSION}\" \"${manual}\" \"${completion}\" COMMAND_ERROR_IS_FATAL ANY)")
install(FILES "${manual}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${completion}" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME overturn)

set(data "${CMAKE_INSTALL_DATADIR}/overturn")
install(DIRECTORY campaigns slurm DESTINATION "${data}" USE_SOURCE_PERMISSIONS
        PATTERN quickstart.sh EXCLUDE  # builds from source
        PATTERN site.env EXCLUDE)      # of the machine it was built on
# Not among one Python's own packages: any Python may read it, and the program finds it from where itself lies.
install(DIRECTORY src/report/overturn DESTINATION "${data}/python" FILES_MATCHING PATTERN "*.py"
        PATTERN __pycache__ EXCLUDE)
install(FILES README.md LICENSE .github/THIRD_PARTY.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
