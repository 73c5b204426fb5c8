using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>Copies planes into the pool as they are, and says of each whether it is what was written and can be drawn
    /// from.</summary>
    [BurstCompile]
    public unsafe struct UploadPlanesJob : IJobFor
    {
        [ReadOnly] public NativeArray<UploadPart> Parts;
        public NativeArray<bool> IsDamaged;

        public void Execute(int index)
        {
            var part = Parts[index];
            // The copy first: then the hash finds the bytes in the cache. What is damaged is not shown.
            UnsafeUtility.MemCpy(part.To, part.From, part.LengthBytes);
            IsDamaged[index] = !part.IsMade && (ContentHash.Of(part.From, part.LengthBytes) != part.Hash ||
                !PlaneView.IsSound(part.From, part.LengthBytes, part.Shape, part.BlockCount));
        }
    }
}
