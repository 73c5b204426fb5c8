using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    internal enum EditRecordKind : uint
    {
        // An operation, as text. What was undone before is gone.
        Operation = 1,
        Undo = 2,
        Redo = 3,
    }

    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct EditHeader
    {
        public const int SizeBytes = 32;

        [FieldOffset(0)] public ulong Magic;
        [FieldOffset(8)] public uint Version;
        [FieldOffset(12)] public int Reserved;
        [FieldOffset(16)] public ulong CloudId;
        [FieldOffset(24)] public ulong HeaderHash;
    }

    // Its text follows, in UTF-8.
    [DiskFormat]
    [StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
    internal struct EditRecord
    {
        public const int SizeBytes = 16;

        [FieldOffset(0)] public EditRecordKind Kind;
        [FieldOffset(4)] public int TextBytes;
        [FieldOffset(8)] public ulong Hash;
    }

    // The operations on a cloud, in a file beside its folder that only grows: undoing is a record too. A record is on the disk
    // before the next one begins; one that a crash cut off is dropped.
    internal sealed unsafe class EditJournal
    {
        // "FPEDITS ", as text.
        public const ulong Magic = 0x2053544944455046UL;
        const uint Version = 1;
        const string Extension = ".edits";
        const int MaxBytes = 1 << 30;

        static int s_writes, s_drafts;
        static volatile Tuple<string, EditOperation> s_draft; // By the journal's path.

        readonly string m_path;
        readonly ulong m_cloudId;
        readonly List<EditOperation> m_operations = new List<EditOperation>();
        long m_fileBytes;
        long m_wholeBytes;

        EditJournal(string path, ulong cloudId) => (m_path, m_cloudId) = (path, cloudId);

        // By this process, to any: whoever shows a cloud looks at its own again when the number rises. Any thread.
        public static int Writes => Volatile.Read(ref s_writes);

        // What is drawn with the brush at this moment, if anything, on the cloud of a journal: it is shown with it, until it is
        // written. Any thread.
        public static EditOperation DraftAt(string journal)
        {
            var draft = s_draft;
            return draft?.Item1 == journal ? draft.Item2 : null;
        }

        // In place of any other; null for none.
        public static void SetDraft(string journal, EditOperation draft)
        {
            s_draft = draft != null ? Tuple.Create(journal, draft) : null;
            Interlocked.Increment(ref s_drafts);
        }

        // Of what is written, and of drafts.
        public static int Changes => Writes + Volatile.Read(ref s_drafts);

        public IReadOnlyList<EditOperation> Operations => m_operations; // In their order; those from Count on are undone.

        public int Count { get; private set; }

        public List<EditOperation> Applied => m_operations.GetRange(0, Count);

        public static string PathOf(string cloud)
        {
            string path = cloud.TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            // "." and ".." are no names.
            return StoreFormat.FinishedPath(path.EndsWith(".", StringComparison.Ordinal) ? Path.GetFullPath(path) : path) +
                Extension;
        }

        // Empty if there is none; a cloud on a server has none.
        public static EditJournal Read(string cloud, ulong cloudId)
        {
            var journal = new EditJournal(PathOf(cloud), cloudId);
            if (SourcePath.IsRemote(cloud) || !File.Exists(journal.m_path))
                return journal;
            journal.m_fileBytes = StoreFile.SizeOf(journal.m_path);
            if (journal.m_fileBytes > MaxBytes)
                throw PointCloudException.Wanted(FailureCode.Unsupported, journal.m_path, -1, "size",
                    "at most " + MaxBytes + " bytes", journal.m_fileBytes);
            using var bytes = StoreFile.Read(journal.m_path, 0, journal.m_fileBytes, Allocator.Persistent);
            journal.ReadHeader(bytes);
            while (journal.m_wholeBytes > 0 && journal.ReadRecord(bytes)) { }
            return journal;
        }

        void ReadHeader(NativeArray<byte> bytes)
        {
            if (bytes.Length < EditHeader.SizeBytes || IsZero(bytes, 0))
                return;
            var header = *(EditHeader*)bytes.GetUnsafeReadOnlyPtr();
            if (header.Magic != Magic)
                throw new PointCloudException(FailureCode.BadInput, m_path, 0, "no journal of edits");
            if (header.Version != Version)
                throw PointCloudException.Wanted(FailureCode.Unsupported, m_path, 8, "version", Version, header.Version);
            if (header.HeaderHash != HashOf(header))
                throw new PointCloudException(FailureCode.BadInput, m_path, 24, "the header is damaged: " +
                    StoreFile.HashProblem(header.HeaderHash, HashOf(header)));
            if (header.CloudId != m_cloudId)
                throw new PointCloudException(FailureCode.BadInput, m_path, 16, "has the edits of another cloud: wanted " +
                    m_cloudId.ToString("x16") + ", got " + header.CloudId.ToString("x16") +
                    "; without this file, the cloud has none");
            m_wholeBytes = EditHeader.SizeBytes;
        }

        // False at the end, or at a record that was not written whole: all that follows is its.
        bool ReadRecord(NativeArray<byte> bytes)
        {
            long left = bytes.Length - m_wholeBytes;
            if (left < EditRecord.SizeBytes || IsZero(bytes, m_wholeBytes))
                return false;
            byte* at = (byte*)bytes.GetUnsafeReadOnlyPtr() + m_wholeBytes;
            var record = *(EditRecord*)at;
            long end = EditRecord.SizeBytes + (long)record.TextBytes;
            if (record.TextBytes < 0 || end > left)
                return record.TextBytes >= 0 ? false : throw Damaged("a negative length");
            ulong hash = HashOf(record, at + EditRecord.SizeBytes);
            if (record.Hash != hash)
                return end == left || IsZero(bytes, m_wholeBytes + end) ? false
                    : throw Damaged(StoreFile.HashProblem(record.Hash, hash));
            Apply(record.Kind, Encoding.UTF8.GetString(at + EditRecord.SizeBytes, record.TextBytes));
            m_wholeBytes += end;
            return true;
        }

        void Apply(EditRecordKind kind, string text)
        {
            if (kind == EditRecordKind.Operation)
            {
                m_operations.RemoveRange(Count, m_operations.Count - Count);
                m_operations.Add(EditOperation.FromJson(text, m_path));
                Count++;
            }
            else if (kind == EditRecordKind.Undo && Count > 0)
                Count--;
            else if (kind == EditRecordKind.Redo && Count < m_operations.Count)
                Count++;
            else
                throw Damaged("no such change, or nothing to undo: " + kind);
        }

        PointCloudException Damaged(string what) =>
            new PointCloudException(FailureCode.BadInput, m_path, m_wholeBytes, "the edit is damaged: " + what);

        // Adds one when it is on the disk. Not for a main thread: it waits for the disk.
        public void Add(EditOperation operation) => Write(EditRecordKind.Operation, operation.ToJson());

        // False if there is nothing to undo.
        public bool TryUndo()
        {
            if (Count == 0)
                return false;
            Write(EditRecordKind.Undo, "");
            return true;
        }

        public bool TryRedo()
        {
            if (Count == m_operations.Count)
                return false;
            Write(EditRecordKind.Redo, "");
            return true;
        }

        void Write(EditRecordKind kind, string text)
        {
            byte[] bytes = BytesOf(kind, text);
            try
            {
                FileChanges.Retry(() =>
                {
                    using var file = FileChanges.OpenToWrite(m_path, FileMode.OpenOrCreate);
                    if (file.Length < m_wholeBytes || file.Length > m_fileBytes)
                        throw new PointCloudException(FailureCode.Changed, m_path, -1,
                            "was changed by another process meanwhile");
                    // Drops what was not written whole, of this attempt too.
                    file.SetLength(m_wholeBytes);
                    file.Position = m_wholeBytes;
                    m_fileBytes = long.MaxValue;
                    file.Write(bytes, 0, bytes.Length);
                    file.Flush(true);
                    m_fileBytes = file.Length;
                });
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                throw new PointCloudException(FileChanges.IsDiskFull(e) ? FailureCode.DiskFull
                    : e is UnauthorizedAccessException ? FailureCode.AccessDenied : FailureCode.WriteFailed, m_path, -1,
                    "cannot be written: " + e.Message, e);
            }
            m_wholeBytes = m_fileBytes;
            Apply(kind, text);
            if (s_draft?.Item1 == m_path)
                s_draft = null;
            Interlocked.Increment(ref s_writes);
        }

        // With the header if there is none.
        byte[] BytesOf(EditRecordKind kind, string text)
        {
            byte[] written = Encoding.UTF8.GetBytes(text);
            var record = new EditRecord { Kind = kind, TextBytes = written.Length };
            fixed (byte* first = written)
                record.Hash = HashOf(record, first);
            var header = new EditHeader { Magic = Magic, Version = Version, CloudId = m_cloudId };
            header.HeaderHash = HashOf(header);
            int at = m_wholeBytes == 0 ? EditHeader.SizeBytes : 0;
            var bytes = new byte[at + EditRecord.SizeBytes + written.Length];
            new ReadOnlySpan<byte>(&header, at).CopyTo(bytes);
            new ReadOnlySpan<byte>(&record, EditRecord.SizeBytes).CopyTo(new Span<byte>(bytes, at, EditRecord.SizeBytes));
            written.CopyTo(bytes, at + EditRecord.SizeBytes);
            return bytes;
        }

        static ulong HashOf(EditHeader header) => ContentHash.Of(&header, EditHeader.SizeBytes - sizeof(ulong));

        static ulong HashOf(EditRecord record, byte* text) =>
            ContentHash.Of(text, record.TextBytes) * 31 ^ (ulong)record.Kind << 32 ^ (ulong)record.TextBytes;

        static bool IsZero(NativeArray<byte> bytes, long from)
        {
            for (int i = (int)from; i < bytes.Length; i++)
                if (bytes[i] != 0)
                    return false;
            return true;
        }
    }
}
