using FastPoints.Points;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>A Potree cloud whose nodes are in an encoding of Potree's own: what the slots ask of it.</summary>
    public abstract class PotreeNodeReader : PotreeReader
    {
        private protected PotreeNodeReader(SourceInfo info, BoundsGeo cube, double spacing) : base(info, cube, spacing)
        {
        }

        internal abstract PotreeLayout Layout { get; }

        /// <summary>Starts to read bytes of the file that holds a block.</summary>
        internal abstract JobHandle BeginRead(NativeFileRead read, int block, long offset, int bytes);

        /// <summary>From a block's corner to the cloud's, in grid steps.</summary>
        internal abstract int3 ShiftOf(int block);
    }
}
