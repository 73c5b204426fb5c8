using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    /// <summary>All points of a source as sorted hashes, to hold two files with the same points in another order against each
    /// other.</summary>
    static class PointMultiset
    {
        public static string[] CommonNames(PointReader a, PointReader b)
        {
            var names = new List<string>();
            foreach (var attribute in a.Info.Schema)
            {
                int other = b.Info.Schema.IndexOf(attribute.Name);
                bool isPosition = attribute.Name == AttributeNames.X || attribute.Name == AttributeNames.Y
                    || attribute.Name == AttributeNames.Z;
                if (other >= 0 && !isPosition && b.Info.Schema[other].Type == attribute.Type)
                    names.Add(attribute.Name);
            }
            return names.ToArray();
        }

        /// <summary>A hash of each point, sorted.</summary>
        /// <param name="step">CRS units to which positions are rounded.</param>
        public static ulong[] Hashes(PointReader reader, string[] names, double3 step)
        {
            ReadPoints.IndexBlocks(reader);
            var hashes = new List<ulong>();
            var all = new List<string>(names) { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            var wanted = reader.Info.Schema.Select(all.ToArray());
            // The same order of columns for both sources.
            var columns = all.ConvertAll(wanted.IndexOf);
            ReadPoints.EachBlock(reader, wanted, read =>
            {
                for (int i = 0; i < read.Points.Count; i++)
                {
                    ulong hash = 14695981039346656037;
                    for (int k = 0; k < names.Length; k++)
                        Mix(ref hash, Bits(read.Points, columns[k], i));
                    var stored = new double3(Number(read.Points, columns[names.Length], i),
                        Number(read.Points, columns[names.Length + 1], i), Number(read.Points, columns[names.Length + 2], i));
                    var geo = reader.Info.Transform.ToGeo(stored);
                    for (int axis = 0; axis < 3; axis++)
                        Mix(ref hash, (ulong)(long)Math.Round(geo[axis] / step[axis]));
                    hashes.Add(hash);
                }
            });
            hashes.Sort();
            return hashes.ToArray();
        }

        /// <param name="step">CRS units to which positions are rounded.</param>
        public static void CheckTwins(PointReader reader, PointReader twin, string[] names, double3 step, int points)
        {
            var got = Hashes(reader, names, step);
            Assert.That(got.Length, Is.EqualTo(points));
            Assert.That(got.SequenceEqual(Hashes(twin, names, step)), Is.True);
        }

        static void Mix(ref ulong hash, ulong value)
        {
            hash = (hash ^ value) * 0x9E3779B97F4A7C15;
            hash ^= hash >> 29;
        }

        static ulong Bits(PointBatch points, int column, int i) => points.Schema[column].Type.SizeOf() switch
        {
            1 => points.Column<byte>(column)[i],
            2 => points.Column<ushort>(column)[i],
            4 => points.Column<uint>(column)[i],
            _ => points.Column<ulong>(column)[i],
        };

        static double Number(PointBatch points, int column, int i) => points.Schema[column].Type switch
        {
            AttributeType.Int32 => points.Column<int>(column)[i],
            AttributeType.Float32 => points.Column<float>(column)[i],
            AttributeType.Float64 => points.Column<double>(column)[i],
            AttributeType.Int64 => points.Column<long>(column)[i],
            _ => throw new NotSupportedException("positions of type " + points.Schema[column].Type),
        };
    }
}
