# SPDX-License-Identifier: Apache-2.0
# Makes a C++ table of one context of a file of translations, for libraries that know no Qt:
#   cmake -DTS=app/translations/hapticell_fr.ts -DCONTEXT=Ergonomics -DOUT=french_table.h -P translation_table.cmake
# Each line of OUT is {"English", "translation"},. What has no translation yet is left out.
file(READ "${TS}" text)
string(FIND "${text}" "<name>${CONTEXT}</name>" begin)
if(begin LESS 0)
  message(FATAL_ERROR "${TS} has no context ${CONTEXT}")
endif()
string(SUBSTRING "${text}" ${begin} -1 text)
string(FIND "${text}" "</context>" end)
string(SUBSTRING "${text}" 0 ${end} text)
string(REPLACE "<name>${CONTEXT}</name>" "" text "${text}")
string(REGEX REPLACE "[ \t]*\n[ \t]*" "" text "${text}")
string(REGEX REPLACE "<message><source>[^<]*</source><translation type=\"unfinished\">[^<]*</translation></message>" ""
  text "${text}")
string(REPLACE "\\" "\\\\" text "${text}")
string(REPLACE "&quot;" "\\\"" text "${text}")
string(REGEX REPLACE "<message><source>([^<]*)</source><translation>([^<]*)</translation></message>"
  "{\"\\1\", \"\\2\"},\n" text "${text}")
string(REPLACE "&lt;" "<" text "${text}")
string(REPLACE "&gt;" ">" text "${text}")
string(REPLACE "&amp;" "&" text "${text}")
if(text MATCHES "<message|</")
  message(FATAL_ERROR "${TS}: context ${CONTEXT} is not written as tools/translations writes it")
endif()
file(WRITE "${OUT}" "// Made of ${CONTEXT} in app/translations by cmake/translation_table.cmake.\n${text}")
