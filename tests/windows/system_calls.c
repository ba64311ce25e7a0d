/* What zig asks of the system that Wine 10 answers otherwise than Windows. Locks of files that tell what became of them
   are refused: it is asked for without a status block, which is filled in here. What is locked by another has another
   error. And the attributes of a file in a folder that is open are looked for in the current folder. */
typedef void * HANDLE;
typedef int NTSTATUS;
typedef struct {
  long long status;
  unsigned long long information;
} IO_STATUS_BLOCK;
typedef long long LARGE_INTEGER;

typedef struct {
  unsigned length;
  HANDLE folder;
} OBJECT_ATTRIBUTES; /* its beginning */

__declspec(dllimport) NTSTATUS NtOpenFile(HANDLE *, unsigned, OBJECT_ATTRIBUTES *, IO_STATUS_BLOCK *, unsigned, unsigned);
__declspec(dllimport) NTSTATUS NtQueryInformationFile(HANDLE, IO_STATUS_BLOCK *, void *, unsigned, unsigned);
__declspec(dllimport) NTSTATUS NtQueryAttributesFile(OBJECT_ATTRIBUTES *, void *);
__declspec(dllimport) NTSTATUS NtClose(HANDLE);
__declspec(dllimport) NTSTATUS NtLockFile(
  HANDLE, HANDLE, void *, void *, IO_STATUS_BLOCK *, LARGE_INTEGER *, LARGE_INTEGER *, unsigned *, unsigned char, unsigned char);
__declspec(dllimport) NTSTATUS NtUnlockFile(HANDLE, IO_STATUS_BLOCK *, LARGE_INTEGER *, LARGE_INTEGER *, unsigned *);

int DllMainCRTStartup(void * instance, unsigned reason, void * reserved)
{
  return 1;
}

#define FILE_LOCK_CONFLICT ((NTSTATUS)0xC0000054)
#define LOCK_NOT_GRANTED ((NTSTATUS)0xC0000055)

static NTSTATUS told(NTSTATUS status, IO_STATUS_BLOCK * block)
{
  if (block) {
    block->status = status;
    block->information = 0;
  }
  return status;
}

NTSTATUS shim_NtLockFile(
  HANDLE file, HANDLE event, void * apc, void * context, IO_STATUS_BLOCK * block, LARGE_INTEGER * offset,
  LARGE_INTEGER * length, unsigned * key, unsigned char at_once, unsigned char exclusive)
{
  NTSTATUS status = NtLockFile(file, event, 0, 0, 0, offset, length, 0, at_once, exclusive);
  return told(status == FILE_LOCK_CONFLICT ? LOCK_NOT_GRANTED : status, block);
}

NTSTATUS shim_NtUnlockFile(
  HANDLE file, IO_STATUS_BLOCK * block, LARGE_INTEGER * offset, LARGE_INTEGER * length, unsigned * key)
{
  return told(NtUnlockFile(file, 0, offset, length, 0), block);
}

#define FILE_READ_ATTRIBUTES 0x80
#define SHARED_WITH_ALL 7
#define FILE_BASIC_INFORMATION 4

NTSTATUS shim_NtQueryAttributesFile(OBJECT_ATTRIBUTES * attributes, void * basic)
{
  HANDLE file;
  IO_STATUS_BLOCK block;
  if (!attributes->folder) {
    return NtQueryAttributesFile(attributes, basic);
  }
  NTSTATUS status = NtOpenFile(&file, FILE_READ_ATTRIBUTES, attributes, &block, SHARED_WITH_ALL, 0);
  if (status) {
    return status;
  }
  status = NtQueryInformationFile(file, &block, basic, 40, FILE_BASIC_INFORMATION);
  NtClose(file);
  return status;
}
