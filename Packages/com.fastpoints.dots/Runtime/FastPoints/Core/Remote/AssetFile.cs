using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Globalization;
using System.Threading;
using System.Threading.Tasks;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using UnityEngine;

namespace FastPoints
{
    // A streaming asset of an Android player. It lies in the player's package, where it has an address (jar:file://) and no path:
    // nothing but AsyncReadManager reads it. It does not change while the player runs.
    internal sealed class AssetFile : RemoteFile
    {
        static readonly ConcurrentDictionary<string, AssetFile> s_opened = new ConcurrentDictionary<string, AssetFile>();

        AssetFile(string address, long length)
        {
            Name = address;
            Length = length;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Register() => Assets = new AssetFiles();

        public override string Name { get; }
        public override long Length { get; }
        public override string Identity => Length.ToString(CultureInfo.InvariantCulture);
        public override bool HasVersion => true;
        public override double RoundTrip => 0;

        public override void DropOpened() { }
        public override void MarkStale() { }
        public override void DropCached() { }

        protected override bool TryReadHead(long offset, Span<byte> into) => false;

        protected override void FindBytes(RemoteRead read)
        {
            var pieces = new List<RangePiece>();
            for (int part = 0; part < read.PartCount; part++)
                for (long at = 0, size = read.PartAt(part).Size; at < size; at += RangeQueue.MaxRequestBytes)
                    pieces.Add(new RangePiece(part, at, (int)Math.Min(RangeQueue.MaxRequestBytes, size - at)));
            RangeQueue.Of(SourcePath.StreamingAssetsPrefix).Add(read, pieces);
        }

        public override async Task Fetch(long offset, long count, byte[] into, Func<int, bool> arrived)
        {
            var memory = Allocate(count);
            try
            {
                var read = Begin(Name, memory, offset, count);
                while (!HasEnded(read))
                    await Task.Delay(1).ConfigureAwait(false);
                var status = read.Status;
                read.Dispose();
                if (status != ReadStatus.Complete)
                    throw new PointCloudException(FailureCode.ReadFailed, Name, offset, "AsyncReadManager says " + status);
                Copy(memory, into, count);
            }
            finally
            {
                Free(memory);
            }
            arrived((int)count);
        }

        // Async methods have no pointers. The command lies before the bytes.
        static unsafe IntPtr Allocate(long count) =>
            (IntPtr)UnsafeUtility.Malloc(sizeof(ReadCommand) + count, 16, Allocator.Persistent);

        static unsafe void Free(IntPtr memory) => UnsafeUtility.Free((void*)memory, Allocator.Persistent);

        static unsafe void Copy(IntPtr memory, byte[] into, long count) =>
            new ReadOnlySpan<byte>((ReadCommand*)memory + 1, (int)count).CopyTo(into);

        static unsafe ReadHandle Begin(string address, IntPtr memory, long offset, long count)
        {
            var command = (ReadCommand*)memory;
            *command = new ReadCommand { Buffer = command + 1, Offset = offset, Size = count };
            return AsyncReadManager.Read(address, command, 1);
        }

        // One that waits has a status without a name.
        static bool HasEnded(ReadHandle read)
        {
            var status = read.Status;
            return status == ReadStatus.Complete || status == ReadStatus.Failed || status == ReadStatus.Truncated ||
                status == ReadStatus.Canceled;
        }

        static unsafe long LengthOf(string address)
        {
            FileInfoResult info = default;
            var read = AsyncReadManager.GetFileInfo(address, &info);
            while (!HasEnded(read))
                Thread.Sleep(1);
            read.Dispose();
            if (info.FileState != FileState.Exists)
                throw new PointCloudException(FailureCode.NotFound, address, -1, "no such file in the player's package");
            return info.FileSize;
        }

        sealed class AssetFiles : IRemoteFiles
        {
            public RemoteFile Open(string address, int headBytes) =>
                s_opened.GetOrAdd(address, a => new AssetFile(a, LengthOf(a)));

            public RemoteFile Find(string address) => s_opened.TryGetValue(address, out var file) ? file : null;

            public RemoteFile Of(string address, long length, string version) => new AssetFile(address, length);
        }
    }
}
