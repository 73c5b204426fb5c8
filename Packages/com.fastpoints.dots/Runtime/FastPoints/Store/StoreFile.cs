using System;
using System.IO;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    // Reads headers and tables on the calling thread. Planes are read in the background.
    internal static unsafe class StoreFile
    {
        const int MaxTextBytes = 16 << 20;

        public static string ReadText(string path, int maxBytes = MaxTextBytes)
        {
            if (!SourcePath.IsRemote(path))
                return Reading(path, file => ReadText(path, file, maxBytes));
            using var bytes = Read(path, 0, Math.Min(SizeOf(path), maxBytes + 1), Allocator.Persistent);
            return ReadText(path, new UnmanagedMemoryStream((byte*)bytes.GetUnsafeReadOnlyPtr(), bytes.Length), maxBytes);
        }

        // False if there is none.
        public static bool TryReadText(string path, out string text, int maxBytes = MaxTextBytes)
        {
            text = null;
            if (!SourcePath.IsRemote(path) && !File.Exists(path))
                return false;
            try
            {
                text = ReadText(path, maxBytes);
                return true;
            }
            // Object storage says of what is missing that it is forbidden.
            catch (PointCloudException e) when (e.Code == FailureCode.NotFound ||
                SourcePath.IsRemote(path) && e.Code == FailureCode.AccessDenied)
            {
                return false;
            }
        }

        static string ReadText(string path, Stream file, int maxBytes)
        {
            if (file.Length > maxBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, path, -1, "size", "at most " + maxBytes +
                    " bytes", file.Length);
            using var reader = new StreamReader(file);
            return reader.ReadToEnd();
        }

        public static long SizeOf(string path) =>
            SourcePath.IsRemote(path) ? RemoteFile.Open(path).Length : Reading(path, file => file.Length);

        // Exactly this many bytes, in memory that the caller disposes.
        public static NativeArray<byte> Read(string path, long offset, long count, Allocator allocator)
        {
            if (SourcePath.IsRemote(path))
                return Read(RemoteFile.Open(path), offset, count, allocator);
            return Reading(path, file =>
            {
                CheckRange(path, file.Length, offset, count);
                var bytes = new NativeArray<byte>((int)count, allocator, NativeArrayOptions.UninitializedMemory);
                file.Position = offset;
                var to = new Span<byte>(bytes.GetUnsafePtr(), bytes.Length);
                while (to.Length > 0)
                {
                    int got = file.Read(to);
                    if (got == 0)
                    {
                        bytes.Dispose();
                        throw new PointCloudException(FailureCode.ReadFailed, path, file.Position, "the file became shorter");
                    }
                    to = to.Slice(got);
                }
                return bytes;
            });
        }

        // The same of a remote file, for pool threads.
        public static NativeArray<byte> Read(RemoteFile file, long offset, long count, Allocator allocator)
        {
            CheckRange(file.Name, file.Length, offset, count);
            var bytes = new NativeArray<byte>((int)count, allocator, NativeArrayOptions.UninitializedMemory);
            try
            {
                file.Read(offset, new Span<byte>(bytes.GetUnsafePtr(), bytes.Length));
                return bytes;
            }
            catch
            {
                bytes.Dispose();
                throw;
            }
        }

        static void CheckRange(string path, long fileBytes, long offset, long count)
        {
            if (offset < 0 || count < 0 || count > int.MaxValue || offset > fileBytes - count)
                throw PointCloudException.Wanted(FailureCode.Truncated, path, Math.Max(0, offset), "bytes", count,
                    Math.Max(0, fileBytes - offset) + " before the end of the file");
        }

        // What is wrong with the head of a container, or null.
        public static string FindProblem(FileHeader header, ulong magic, ulong cloudId, long fileBytes)
        {
            if (header.Magic != magic)
                return "not the file that its name says: wanted magic " + magic.ToString("x16") + ", got " +
                    header.Magic.ToString("x16");
            if (header.Version != StoreFormat.Version)
                return "version: wanted " + StoreFormat.Version + ", got " + header.Version;
            ulong hash = HashOf(header);
            if (header.HeaderHash != hash)
                return "the header is damaged: " + HashProblem(header.HeaderHash, hash);
            if (header.CloudId != cloudId)
                return "is of another cloud";
            return header.Container.FileBytes == fileBytes ? null
                : "wanted " + header.Container.FileBytes + " bytes, got " + fileBytes;
        }

        public static ulong HashOf(FileHeader header) => ContentHash.Of(&header, FileHeader.SizeBytes - sizeof(ulong));

        // Throws if bytes of a file are not those that the hash was made of; none is made where it is 0.
        public static void CheckHash(string path, long offset, NativeArray<byte> bytes, ulong wanted)
        {
            ulong got = wanted == 0 ? 0 : ContentHash.Of(bytes.GetUnsafeReadOnlyPtr(), bytes.Length);
            if (got != wanted)
                throw new PointCloudException(FailureCode.BadInput, path, offset, HashProblem(wanted, got));
        }

        public static string HashProblem(ulong wanted, ulong got) =>
            "its hash does not fit: wanted " + wanted.ToString("x16") + ", got " + got.ToString("x16");

        static T Reading<T>(string path, Func<FileStream, T> read)
        {
            try
            {
                using var file = FileChanges.OpenToRead(path, 4096);
                return read(file);
            }
            catch (Exception e) when (e is FileNotFoundException || e is DirectoryNotFoundException)
            {
                throw new PointCloudException(FailureCode.NotFound, path, -1, "no such file", e);
            }
            catch (UnauthorizedAccessException e)
            {
                throw new PointCloudException(Directory.Exists(path) ? FailureCode.NotFound : FailureCode.AccessDenied, path, -1,
                    Directory.Exists(path) ? "is a folder, wanted a file" : "cannot be read: permission denied", e);
            }
            catch (Exception e) when (e is IOException || e is ArgumentException || e is NotSupportedException)
            {
                throw new PointCloudException(FailureCode.ReadFailed, path, -1, "cannot be read: " + e.Message, e);
            }
        }
    }
}
