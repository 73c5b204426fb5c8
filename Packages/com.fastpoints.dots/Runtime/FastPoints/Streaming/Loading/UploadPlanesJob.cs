using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>One plane of one node to be copied into the pool.</summary>
    internal unsafe struct UploadPart
    {
        public byte* From;
        public byte* To;
        public long LengthBytes;

        /// <summary>Hash of the bytes as written.</summary>
        public ulong Hash;
        public UploadCheck Check;
        public PlaneShape Shape;
        public int BlockCount;

        /// <summary>The upload of the frame that it belongs to.</summary>
        public int Upload;
    }

    /// <summary>What is checked of a plane before it is drawn.</summary>
    internal enum UploadCheck : byte
    {
        /// <summary>It was just made in memory.</summary>
        None,
        /// <summary>Its hash was right before. No bytes of a file may lead outside of it, whatever became of the file.</summary>
        Shape,
        Hash,
    }

    /// <summary>Copies planes into the pool unchanged, and reports of each whether it is what was written and can be drawn.
    /// Damaged data is not shown.</summary>
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
