using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Text;

namespace FastPoints.Reading
{
    // EPSG's coordinate systems: kinds, units, order of axes, names. "RepoTools epsg" generates the data.
    internal static partial class EpsgTable
    {
        const int CompoundKind = byte.MaxValue;

        static readonly Lazy<Dictionary<int, double>> s_metresOfUnit = new Lazy<Dictionary<int, double>>(ReadUnits);
        static readonly Lazy<byte[]> s_codes = new Lazy<byte[]>(() => Convert.FromBase64String(Codes));
        static readonly Lazy<string[]> s_names = new Lazy<string[]>(ReadNames);
        static readonly string[] s_kinds = Kinds.Split(';');

        /// <summary>Length of EPSG's unit of a code in metres: NaN for degrees, 0 for unknown units and other
        /// angles.</summary>
        public static double MetresPerUnit(int code) => s_metresOfUnit.Value.TryGetValue(code, out double metres) ? metres : 0;

        /// <summary>Null if there is no such system.</summary>
        public static EpsgSystem Find(int code)
        {
            // Searched from the start, code by code: only a few are looked up, at 10 us each.
            byte[] codes = s_codes.Value;
            int current = 0, index = 0;
            for (int at = 0; at < codes.Length; index++)
            {
                for (int shift = 0, more = 1; more != 0; shift += 7)
                {
                    current += (codes[at] & 127) << shift;
                    more = codes[at++] & 128;
                }
                int kind = codes[at++];
                if (current == code)
                    return kind != CompoundKind ? Parse(s_kinds[kind], index)
                        : Join(Find(codes[at] | codes[at + 1] << 8), Find(codes[at + 2] | codes[at + 3] << 8), index);
                at += kind == CompoundKind ? 4 : 0;
            }
            return null;
        }

        public static string NameOf(EpsgSystem system) => s_names.Value[system.Index];

        static EpsgSystem Parse(string text, int index)
        {
            string[] parts = text.Split(' ');
            double unit = MetresPerUnit(int.Parse(parts[1]));
            bool isVertical = parts[0] == "V";
            return new EpsgSystem
            {
                Index = index,
                Kind = parts[0] == "P" ? CrsKind.Projected : parts[0] == "G" ? CrsKind.Geographic
                    : isVertical ? CrsKind.Vertical : CrsKind.Geocentric,
                MetresPerUnit = isVertical ? 0 : unit,
                VerticalMetresPerUnit = isVertical ? unit : parts.Length > 4 ? MetresPerUnit(int.Parse(parts[4])) : 0,
                Axes = isVertical ? parts[2] : parts[2] + parts[3],
            };
        }

        static EpsgSystem Join(EpsgSystem horizontal, EpsgSystem vertical, int index) => new EpsgSystem
        {
            Index = index,
            Kind = horizontal.Kind,
            MetresPerUnit = horizontal.MetresPerUnit,
            VerticalMetresPerUnit = vertical.VerticalMetresPerUnit,
            Axes = horizontal.Axes + vertical.Axes,
        };

        static Dictionary<int, double> ReadUnits()
        {
            var units = new Dictionary<int, double>();
            foreach (string unit in Units.Split(';'))
            {
                int space = unit.IndexOf(' ');
                if (!NumberText.TryRead(unit.Substring(space + 1), out double metres))
                    metres = double.NaN;
                units.Add(int.Parse(unit.Substring(0, space)), metres);
            }
            return units;
        }

        static string[] ReadNames()
        {
            using var names = new StreamReader(new DeflateStream(new MemoryStream(Convert.FromBase64String(Names)),
                CompressionMode.Decompress), Encoding.UTF8);
            return names.ReadToEnd().Split('\n');
        }
    }

    internal sealed class EpsgSystem
    {
        public int Index;
        public CrsKind Kind;

        public double MetresPerUnit;
        public double VerticalMetresPerUnit;
        public string Axes; // A letter each: E east, N north, W, S, U up, D down, - another.
    }
}
