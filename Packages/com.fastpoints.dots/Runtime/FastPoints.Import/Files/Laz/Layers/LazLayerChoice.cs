using System;
using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>Which layers of a chunk the wanted attributes lie in.</summary>
    static class LazLayerChoice
    {
        const int ReturnByte = 14;
        const int FlagByte = 15;
        const int ScannerChannelShift = 4;

        /// <summary>By layer. The first is always wanted: the others' contexts come from it.</summary>
        /// <exception cref="ArgumentException">An attribute that the records do not have.</exception>
        public static bool[] Make(LazLayer[] layers, LasRecordLayout layout, PointSchema wanted)
        {
            var isWanted = new bool[layers.Length];
            isWanted[0] = true;
            foreach (var attribute in wanted)
            {
                if (!layout.TryFind(attribute.Name, out var field))
                    throw new ArgumentException("the records have no attribute " + attribute, nameof(wanted));
                // Return counts and the scanner channel come with the first layer.
                if (field.ByteOffset == ReturnByte || field.ByteOffset == FlagByte && field.BitShift == ScannerChannelShift)
                    continue;
                int end = field.ByteOffset + field.Type.SizeOf();
                for (int i = 0; i < layers.Length; i++)
                    isWanted[i] |= field.ByteOffset < layers[i].RecordOffset + layers[i].RecordBytes
                        && end > layers[i].RecordOffset;
            }
            return isWanted;
        }
    }
}
