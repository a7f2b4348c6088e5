/* SPDX-License-Identifier: Apache-2.0
 *
 * The program in front of an AppImage: behind it in the same file is a squashfs image with the programs and their libraries.
 * It unpacks the image once into the user's cache and starts AppRun there. It mounts nothing, so it needs neither FUSE nor
 * rights. tools/appimage builds it.
 *
 *   HaptiCell.AppImage [ARGUMENTS]          starts the window
 *   HaptiCell.AppImage --appimage-extract   unpacks into ./squashfs-root
 *   HaptiCell.AppImage --appimage-offset    prints where the image begins
 */
#include <elf.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <limits.h>
#include <squashfuse/squashfuse.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* The image is packed by zstd. libsquashfuse asks for the other methods too; liblzo2 is under the GPL and must not be linked. */
int lzo1x_decompress_safe(void) { return -1; }
int LZ4_decompress_safe(void) { return -1; }
int lzma_stream_buffer_decode(void) { return 11; } /* LZMA_PROG_ERROR */

static void stop(const char* form, ...) {
  va_list words;
  va_start(words, form);
  fputs("AppImage: ", stderr);
  vfprintf(stderr, form, words);
  fputc('\n', stderr);
  va_end(words);
  exit(1);
}

static char* text(const char* form, ...) {
  char* made = NULL;
  va_list words;
  va_start(words, form);
  if (vasprintf(&made, form, words) < 0) stop("no memory is left");
  va_end(words);
  return made;
}

/* The image begins where the ELF file ends: behind its table of sections. */
static size_t imageOffset(int file) {
  Elf64_Ehdr head;
  if (pread(file, &head, sizeof head, 0) != sizeof head || memcmp(head.e_ident, ELFMAG, SELFMAG) != 0)
    stop("the file itself cannot be read");
  return head.e_shoff + (size_t)head.e_shentsize * head.e_shnum;
}

static void writeFile(sqfs* image, sqfs_inode* node, const char* path, mode_t mode) {
  static char block[1 << 17];
  int file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (file < 0) stop("%s cannot be written: %s", path, strerror(errno));
  for (uint64_t at = 0; at < node->xtra.reg.file_size;) {
    sqfs_off_t size = sizeof block;
    if (sqfs_read_range(image, node, (sqfs_off_t)at, &size, block) != SQFS_OK || size <= 0)
      stop("the image is damaged at %s; download the file again", path);
    if (write(file, block, (size_t)size) != (ssize_t)size) stop("%s cannot be written: %s", path, strerror(errno));
    at += (uint64_t)size;
  }
  if (close(file) != 0) stop("%s cannot be written: %s", path, strerror(errno));
}

static void writeLink(sqfs* image, sqfs_inode* node, const char* path) {
  char target[PATH_MAX];
  size_t size = sizeof target;
  if (sqfs_readlink(image, node, target, &size) != SQFS_OK) stop("the image is damaged at %s", path);
  if (symlink(target, path) != 0) stop("%s cannot be written: %s", path, strerror(errno));
}

static void unpack(const char* self, size_t offset, const char* folder) {
  sqfs image;
  sqfs_traverse walk;
  sqfs_err fault = SQFS_OK;
  if (sqfs_open_image(&image, self, offset) != SQFS_OK) stop("there is no image behind the program; download the file again");
  if (sqfs_traverse_open(&walk, &image, sqfs_inode_root(&image)) != SQFS_OK) stop("the image is damaged");
  while (sqfs_traverse_next(&walk, &fault)) {
    sqfs_inode node;
    if (walk.dir_end) continue;
    if (sqfs_inode_get(&image, &node, walk.entry.inode) != SQFS_OK) stop("the image is damaged at %s", walk.path);
    char* path = text("%s/%s", folder, walk.path);
    const mode_t mode = node.base.mode;
    if (S_ISDIR(mode)) {
      if (mkdir(path, 0755) != 0) stop("%s cannot be made: %s", path, strerror(errno));
    } else if (S_ISREG(mode)) {
      writeFile(&image, &node, path, (mode & 0111) != 0 ? 0755 : 0644);
    } else if (S_ISLNK(mode)) {
      writeLink(&image, &node, path);
    }
    free(path);
  }
  if (fault != SQFS_OK) stop("the image is damaged");
  sqfs_traverse_close(&walk);
  sqfs_destroy(&image);
}

static int removeOne(const char* path, const struct stat* state, int kind, struct FTW* place) {
  (void)state, (void)kind, (void)place;
  return remove(path);
}

static void makeFolders(char* path) {
  for (char* slash = path + 1; (slash = strchr(slash, '/')) != NULL; ++slash) {
    *slash = 0;
    mkdir(path, 0700);
    *slash = '/';
  }
  mkdir(path, 0700);
}

/* ~/.cache/hapticell/appimage: a folder of this user that nobody else may write. */
static char* cacheFolder(void) {
  const char* cache = getenv("XDG_CACHE_HOME");
  const char* home = getenv("HOME");
  if (cache == NULL || cache[0] != '/') {
    if (home == NULL || home[0] != '/') stop("HOME names no folder: the program has no place to unpack to");
    cache = text("%s/.cache", home);
  }
  char* folder = text("%s/hapticell/appimage", cache);
  struct stat state;
  makeFolders(folder);
  if (lstat(folder, &state) != 0 || !S_ISDIR(state.st_mode)) stop("%s cannot be made", folder);
  if (state.st_uid != geteuid() || (state.st_mode & 022) != 0) stop("%s can be written by others", folder);
  return folder;
}

/* Unpacks unless a run before did. A lock keeps two starts at once apart; only a whole copy gets its name. */
static char* unpackedFolder(const char* self, size_t offset) {
  char* cache = cacheFolder();
  char* folder = text("%s/%s", cache, APPIMAGE_ID);
  struct stat state;
  const int lock = open(text("%s/lock", cache), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock < 0 || flock(lock, LOCK_EX) != 0) stop("%s cannot be locked: %s", cache, strerror(errno));
  if (stat(folder, &state) != 0) {
    char* part = text("%s/part", cache);
    fprintf(stderr, "AppImage: the first start unpacks to %s\n", folder);
    nftw(part, removeOne, 16, FTW_DEPTH | FTW_PHYS);
    if (mkdir(part, 0700) != 0) stop("%s cannot be made: %s", part, strerror(errno));
    unpack(self, offset, part);
    if (rename(part, folder) != 0) stop("%s cannot be made: %s", folder, strerror(errno));
  }
  close(lock);
  return folder;
}

int main(int count, char** words) {
  static char self[PATH_MAX];
  (void)count;
  umask(022);
  if (readlink("/proc/self/exe", self, sizeof self - 1) < 0) stop("/proc is not mounted");
  const int file = open(self, O_RDONLY | O_CLOEXEC);
  if (file < 0) stop("%s cannot be read: %s", self, strerror(errno));
  const size_t offset = imageOffset(file);
  close(file);
  if (words[1] != NULL && strcmp(words[1], "--appimage-offset") == 0) return printf("%zu\n", offset) < 0;
  if (words[1] != NULL && strcmp(words[1], "--appimage-extract") == 0) {
    if (mkdir("squashfs-root", 0755) != 0) stop("squashfs-root cannot be made: %s", strerror(errno));
    unpack(self, offset, "squashfs-root");
    return 0;
  }
  char* folder = unpackedFolder(self, offset);
  setenv("APPDIR", folder, 1);
  setenv("APPIMAGE", self, 1);
  setenv("ARGV0", words[0] != NULL ? words[0] : "", 1);
  char* program = text("%s/AppRun", folder);
  execv(program, words);
  stop("%s cannot be started: %s", program, strerror(errno));
}
