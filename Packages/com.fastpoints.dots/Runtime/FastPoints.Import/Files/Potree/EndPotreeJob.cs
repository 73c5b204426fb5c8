using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Says how the decoding of a compressed range ended: all of its points or none, since the values of one point are
    /// spread over the whole stream.</summary>
    [BurstCompile]
    struct EndPotreeJob : IJob
    {
        [ReadOnly] public NativeReference<DecompressState> State;
        public NativeReference<DecodeResult> Result;
        public int Points;

        /// <summary>Of the stream in the file.</summary>
        public long Offset;

        public void Execute()
        {
            var state = State.Value;
            Result.Value = state.IsBroken
                ? new DecodeResult { Error = PotreeError.Broken, ErrorOffset = Offset + state.Consumed }
                : new DecodeResult { Points = Points };
        }
    }
}
