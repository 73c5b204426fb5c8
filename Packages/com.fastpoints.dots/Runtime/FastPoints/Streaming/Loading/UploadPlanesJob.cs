using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    internal unsafe struct UploadPart
    {
        public byte* From;
        public byte* To;
        public long LengthBytes;
        public ulong Hash;
        public UploadCheck Check;
        public PlaneShape Shape;
        public int BlockCount;
        public int Upload;
    }

    internal enum UploadCheck : byte
    {
        // It was just made in memory.
        None,
        // Its hash was right before. No bytes of a file may lead outside of it, whatever became of the file.
        Shape,
        Hash,
    }

    // Copies planes into the pool unchanged, and reports of each whether it is what was written and can be drawn.
    [BurstCompile]
    internal unsafe struct UploadPlanesJob : IJobFor
    {
        [ReadOnly] public NativeArray<UploadPart> Parts;
        public NativeArray<bool> IsDamaged;

        public void Execute(int index)
        {
            var part = Parts[index];
            bool isValid = true;
            if (part.Check == UploadCheck.Hash)
                isValid = ContentHash.Copy(part.To, part.From, part.LengthBytes) == part.Hash;
            else
                UnsafeUtility.MemCpy(part.To, part.From, part.LengthBytes);
            IsDamaged[index] = !isValid || part.Check != UploadCheck.None &&
                !PlaneView.IsValid(part.From, part.LengthBytes, part.Shape, part.BlockCount);
        }
    }
}
