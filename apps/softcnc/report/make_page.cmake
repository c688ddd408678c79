# SPDX-License-Identifier: MIT
# Writes PAGE (an HTML file) into SOURCE (C++), by TEMPLATE: cmake -DPAGE=... -P make_page.cmake
# No string literal is longer than what every compiler must take.
file(READ ${PAGE} text HEX)
string(LENGTH "${text}" length)
set(digits 32000)
set(PAGE_PIECES "")
set(begin 0)
while(begin LESS length)
  string(SUBSTRING "${text}" ${begin} ${digits} piece)
  string(REGEX REPLACE "(..)" "\\\\x\\1" piece "${piece}")
  string(LENGTH "${piece}" escaped)
  math(EXPR bytes "${escaped} / 4")
  string(APPEND PAGE_PIECES "\n    {\"${piece}\", ${bytes}},")
  math(EXPR begin "${begin} + ${digits}")
endwhile()
configure_file(${TEMPLATE} ${SOURCE} @ONLY)
