// SPDX-License-Identifier: MIT
// Preloaded into rs274, lets it print numbers so that they read back exactly instead of with four places, which in inches
// are 2.5 um.
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static void widen(const char *format, char *wide, size_t room) {
  size_t length = 0;
  while (*format != '\0' && length + 6 < room) {
    const size_t fixed = strncmp(format, "%.4f", 4) == 0 ? 4 : strncmp(format, "%f", 2) == 0 ? 2 : 0;
    if (fixed == 0) {
      wide[length++] = *format++;
      continue;
    }
    memcpy(wide + length, "%.17g", 5);
    length += 5;
    format += fixed;
  }
  wide[length] = '\0';
}

int __vfprintf_chk(FILE *file, int flag, const char *format, va_list values) {
  char wide[1000];
  (void)flag;
  widen(format, wide, sizeof wide);
  return vfprintf(file, wide, values);
}

int __fprintf_chk(FILE *file, int flag, const char *format, ...) {
  va_list values;
  va_start(values, format);
  const int written = __vfprintf_chk(file, flag, format, values);
  va_end(values);
  return written;
}
