using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>A box in the world, freely rotated and sheared. Boxes that cut remove what is inside; other boxes keep only
    /// what is inside at least one of them.</summary>
    public struct ClipBox
    {
        public double3 CenterWorld;

        /// <summary>World vectors of the box's three edges. A box without volume contains nothing.</summary>
        public double3x3 EdgesWorld;
        public bool Cuts;

        public ClipBox(double3 minWorld, double3 maxWorld, bool cuts = false)
        {
            var size = maxWorld - minWorld;
            CenterWorld = (minWorld + maxWorld) / 2;
            EdgesWorld = new double3x3(new double3(size.x, 0, 0), new double3(0, size.y, 0), new double3(0, 0, size.z));
            Cuts = cuts;
        }
    }

    // Inside the box, no coordinate of ToBox * position + Offset, in one cloud's own space, is farther than a half from 0.
    internal unsafe struct LocalClip
    {
        public double3x3 ToBox;
        public double3 Offset;
        public bool Cuts;

        public LocalClip(in ClipBox box, in CloudPlacement placement)
        {
            var toBox = math.inverse(box.EdgesWorld);
            ToBox = math.mul(toBox, placement.Linear);
            Offset = math.mul(toBox, placement.OriginWorld - box.CenterWorld);
            Cuts = box.Cuts;
        }

        // Whether clips keep a position. A box holds its faces, whether it keeps or cuts: what rounding alone puts outside
        // counts as inside.
        public static bool Keeps(LocalClip* clips, int count, double3 position)
        {
            bool isKept = false, doesAnyKeep = false;
            var rounding = math.abs(position) * 4.5e-16;
            for (int i = 0; i < count; i++)
            {
                var toBox = clips[i].ToBox;
                var at = math.abs(math.mul(toBox, position) + clips[i].Offset);
                var reach = math.abs(toBox.c0) * rounding.x + math.abs(toBox.c1) * rounding.y + math.abs(toBox.c2) * rounding.z;
                bool isInside = math.all(at - reach <= 0.5);
                if (isInside && clips[i].Cuts)
                    return false;
                doesAnyKeep |= !clips[i].Cuts;
                isKept |= isInside;
            }
            return isKept || !doesAnyKeep;
        }

        // Whether clips keep anything of a box; perhaps true if they keep nothing, but exact for a position (half is 0).
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static bool MayKeep(LocalClip* clips, int count, double3 center, double3 half)
        {
            bool isKept = false, doesAnyKeep = false;
            for (int i = 0; i < count; i++)
            {
                var toBox = clips[i].ToBox;
                var at = math.abs(math.mul(toBox, center) + clips[i].Offset);
                var reach = math.abs(toBox.c0) * half.x + math.abs(toBox.c1) * half.y + math.abs(toBox.c2) * half.z;
                if (clips[i].Cuts && math.all(at + reach <= 0.5))
                    return false;
                doesAnyKeep |= !clips[i].Cuts;
                isKept |= !clips[i].Cuts && math.all(at - reach <= 0.5);
            }
            return isKept || !doesAnyKeep;
        }
    }
}
