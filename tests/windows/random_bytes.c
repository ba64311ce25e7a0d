/* bcryptprimitives.ProcessPrng, which the modules written in Rust import and Wine 8 lacks. */

int __stdcall DllMainCRTStartup(void *library, unsigned reason, void *reserved) { return 1; }

__declspec(dllimport) unsigned char __stdcall SystemFunction036(void *buffer, unsigned long length); /* RtlGenRandom */

__declspec(dllexport) int __stdcall ProcessPrng(unsigned char *data, unsigned long long size) {
  return SystemFunction036(data, (unsigned long)size);
}
