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

        public static string ReadText(string path) =>
            Reading(path, file =>
            {
                if (file.Length > MaxTextBytes)
                    throw PointCloudException.Wanted(FailureCode.BadInput, path, -1, "size", "at most " + MaxTextBytes +
                        " bytes", file.Length);
                using var reader = new StreamReader(file);
                return reader.ReadToEnd();
            });

        public static long SizeOf(string path) => Reading(path, file => file.Length);

        // Exactly this many bytes, in memory that the caller disposes.
        public static NativeArray<byte> Read(string path, long offset, long count, Allocator allocator)
        {
            return Reading(path, file =>
            {
                if (offset < 0 || count < 0 || count > int.MaxValue || offset > file.Length - count)
                {
                    throw PointCloudException.Wanted(FailureCode.Truncated, path, Math.Max(0, offset), "bytes", count,
                        Math.Max(0, file.Length - offset) + " before the end of the file");
                }
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

        public static FileHeader ReadHeader(string path, ulong magic)
        {
            using var bytes = Read(path, 0, FileHeader.SizeBytes, Allocator.Persistent);
            var header = *(FileHeader*)bytes.GetUnsafeReadOnlyPtr();
            string problem = FindProblem(header, magic, SizeOf(path));
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
