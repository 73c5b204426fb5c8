using FastPoints.Core;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>Turns statistics of a cloud's attributes into the manifest's description of them.</summary>
    internal static unsafe class AttributeSummary
    {
        /// <summary>Sets divisors and ranges.</summary>
        public static void Describe(PointSchema attributes, AttributeStatistics[] found, CloudManifest manifest)
        {
            manifest.Divisors = new int[attributes.Count];
            manifest.Ranges = new CloudManifest.Range[attributes.Count];
            for (int a = 0; a < attributes.Count; a++)
            {
                var attribute = attributes[a];
                manifest.Divisors[a] = attribute.Type == AttributeType.UInt16 ? DivisorOf(found[a]) : 1;
                manifest.Ranges[a] = found[a].IsEmpty
                    ? new CloudManifest.Range { Min = double.NaN, Max = double.NaN }
                    : new CloudManifest.Range
                    {
                        Min = ValueOf(found[a].Min, attribute.Type) * attribute.Scale + attribute.Offset,
                        Max = ValueOf(found[a].Max, attribute.Type) * attribute.Scale + attribute.Offset,
                    };
            }
        }

        /// <summary>The divisor, if 8-bit colours fill 16-bit fields in one of two ways: shifted up, or doubled.</summary>
        static int DivisorOf(in AttributeStatistics found)
        {
            if (found.Or == 0)
                return 1;
            return found.NotDoubled == 0 ? 257 : 1 << math.tzcnt((uint)found.Or);
        }

        static double ValueOf(ulong ordered, AttributeType type)
        {
            ulong bits = 0;
            OrderedBits.Store(ordered, type, (byte*)&bits);
            return ColumnValues.ToDouble((byte*)&bits, type, 0);
        }
    }
}
