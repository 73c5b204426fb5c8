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

        public static string ReadText(string path)
        {
            if (!SourcePath.IsRemote(path))
                return Reading(path, file => ReadText(path, file));
            using var bytes = Read(path, 0, Math.Min(SizeOf(path), MaxTextBytes + 1), Allocator.Persistent);
            return ReadText(path, new UnmanagedMemoryStream((byte*)bytes.GetUnsafeReadOnlyPtr(), bytes.Length));
        }

        // False if there is none.
        public static bool TryReadText(string path, out string text)
        {
            text = null;
            if (!SourcePath.IsRemote(path) && !File.Exists(path))
                return false;
            try
            {
                text = ReadText(path);
                return true;
            }
            // Object storage says of what is missing that it is forbidden.
            catch (PointCloudException e) when (e.Code == FailureCode.NotFound ||
                SourcePath.IsRemote(path) && e.Code == FailureCode.AccessDenied)
            {
                return false;
            }
        }

        static string ReadText(string path, Stream file)
        {
            if (file.Length > MaxTextBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, path, -1, "size", "at most " + MaxTextBytes +
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

        public static FileHeader ReadHeader(string path, ulong magic)
        {
            using var bytes = Read(path, 0, FileHeader.SizeBytes, Allocator.Persistent);
            return HeaderOf(path, bytes, magic, SizeOf(path));
        }

        // All of a file that has a header.
        public static NativeArray<byte> ReadWhole(string path, ulong magic, out FileHeader header)
        {
            long size = SizeOf(path);
            var bytes = Read(path, 0, Math.Max(FileHeader.SizeBytes, size), Allocator.Persistent);
            try
            {
                header = HeaderOf(path, bytes, magic, size);
                return bytes;
            }
            catch
            {
                bytes.Dispose();
                throw;
            }
        }

        static FileHeader HeaderOf(string path, NativeArray<byte> bytes, ulong magic, long fileBytes)
        {
            var header = *(FileHeader*)bytes.GetUnsafeReadOnlyPtr();
            string problem = FindProblem(header, magic, fileBytes);
            if (problem != null)
                throw new PointCloudException(FailureCode.BadInput, path, 0, problem);
            return header;
        }

        public static string FindProblem(FileHeader header, ulong magic, long fileBytes)
        {
            if (header.Magic != magic)
                return "not the file that its name says: wanted magic " + magic.ToString("x16") + ", got " +
                    header.Magic.ToString("x16");
            if (header.Version != StoreFormat.Version)
                return "version: wanted " + StoreFormat.Version + ", got " + header.Version;
            ulong hash = ContentHash.Of(&header, FileHeader.SizeBytes - sizeof(ulong));
            if (header.HeaderHash != hash)
                return "the header is damaged: " + HashProblem(header.HeaderHash, hash);
            if (header.FileBytes != fileBytes)
                return "wanted " + header.FileBytes + " bytes, got " + fileBytes;
            long table = (long)header.NodeCount * (NodeRecord.SizeBytes + (long)header.PlaneCount * PlaneRange.SizeBytes) +
                (long)header.ChunkCount * ChunkRecord.SizeBytes;
            if (header.NodeCount < 0 || header.ChunkCount < 0 || header.PlaneCount < 1 || header.PlaneCount > 4096 ||
                header.PointCount < 0 || header.TableOffset < FileHeader.SizeBytes || header.TableOffset != fileBytes - table)
                return "a table of " + header.NodeCount + " nodes, " + header.ChunkCount + " chunks and " + header.PlaneCount +
                    " planes at " + header.TableOffset + " does not end the file";
            return null;
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
