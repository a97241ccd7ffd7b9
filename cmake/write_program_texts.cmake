# cmake -DPROGRAM=FILE -DFOLDER=FOLDER -P write_program_texts.cmake: a program's manual page and completions, which it writes
# itself from its table of options.

get_filename_component(name "${PROGRAM}" NAME_WE)
file(MAKE_DIRECTORY "${FOLDER}")
execute_process(COMMAND "${PROGRAM}" --man OUTPUT_FILE "${FOLDER}/${name}.1" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${PROGRAM}" --completion bash OUTPUT_FILE "${FOLDER}/${name}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${PROGRAM}" --completion zsh OUTPUT_FILE "${FOLDER}/_${name}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${PROGRAM}" --completion fish OUTPUT_FILE "${FOLDER}/${name}.fish" COMMAND_ERROR_IS_FATAL ANY)
