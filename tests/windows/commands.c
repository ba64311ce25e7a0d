/* echo, true, false and sleep, as Git for Windows brings them: which one it is, its name says. No C library is used. */
#define IN __declspec(dllimport)
IN const char *__stdcall GetCommandLineA(void);
IN unsigned long __stdcall GetModuleFileNameA(void *module, char *name, unsigned long size);
IN void *__stdcall GetStdHandle(unsigned long which);
IN int __stdcall WriteFile(void *file, const void *data, unsigned long size, unsigned long *written, void *none);
IN void __stdcall Sleep(unsigned long milliseconds);
IN void __stdcall ExitProcess(unsigned code);

static void say(const char *text, unsigned long size) {
  unsigned long written;
  WriteFile(GetStdHandle((unsigned long)-11), text, size, &written, 0);
}

/* The words after the program's own, one after the other; quotation marks are left out. */
static const char *word(const char *line, const char **end) {
  int quoted = 0;
  while (*line == ' ') line++;
  for (*end = line; **end && (quoted || **end != ' '); (*end)++) quoted ^= **end == '"';
  return line;
}

static void echo(const char *line) {
  const char *end, *begin = word(line, &end);
  for (int first = 1; *begin; first = 0, begin = word(end, &end)) {
    if (!first) say(" ", 1);
    for (; begin < end; begin++) if (*begin != '"') say(begin, 1);
  }
  say("\n", 1);
}

static void wait(const char *line) {
  double seconds = 0, place = 0;
  const char *end, *begin = word(line, &end);
  for (; begin < end; begin++) {
    if (*begin == '.') { place = 0.1; continue; }
    if (place) { seconds += (*begin - '0') * place; place /= 10; }
    else seconds = 10 * seconds + (*begin - '0');
  }
  Sleep((unsigned long)(1000 * seconds));
}

int _fltused = 1;

void mainCRTStartup(void) {
  char own[1024];
  const char *rest, *name = own;
  GetModuleFileNameA(0, own, sizeof own);
  for (const char *at = own; *at; at++) if (*at == '\\') name = at + 1;
  word(GetCommandLineA(), &rest);
  if (*name == 'e') echo(rest);
  if (*name == 's') wait(rest);
  ExitProcess(*name == 'f');
}
