using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace FastPoints.Tests
{
    sealed class E57TestScan
    {
        public readonly List<E57TestField> Fields = new List<E57TestField>();
        public string Xml = "";
        public string RecordCount;
        public string FileOffset;
        public E57Packing Packing = E57Packing.Even;
        public int RecordsPerPacket = 1000;
        public bool HasIndex = true;
        public bool HasIgnored;
        public bool HasRestartFlag;

        public E57TestScan(params E57TestField[] fields) => Fields.AddRange(fields);

        public int Count => Fields[0].Count;

        /// <param name="numbers">The rotation's w, x, y and z, then the translation.</param>
        public static string Pose(params double[] numbers) => string.Format(CultureInfo.InvariantCulture,
                "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">{0:R}</w><x type=\"Float\">{1:R}</x>" +
                "<y type=\"Float\">{2:R}</y><z type=\"Float\">{3:R}</z></rotation><translation type=\"Structure\">" +
                "<x type=\"Float\">{4:R}</x><y type=\"Float\">{5:R}</y><z type=\"Float\">{6:R}</z></translation></pose>",
                numbers.Cast<object>().ToArray());
    }

    sealed class E57TestField
    {
        public string Name;
        public string Type;
        public bool IsSingle;
        public bool HasLimits = true; // Limits of integers; without them the XML gives none, and values take 64 bits.
        public long Minimum;
        public long Maximum;
        public double Scale = 1;
        public double Offset;

        public long[] Integers;
        public double[] Reals;
        public string Xml; // What stands in the XML instead of the element that the others give, or null.

        public static E57TestField Integer(string name, long minimum, long maximum, params long[] values) =>
            new E57TestField { Name = name, Type = "Integer", Minimum = minimum, Maximum = maximum, Integers = values };

        public static E57TestField Scaled(string name, long minimum, long maximum, double scale, double offset,
            params long[] values) => new E57TestField
            {
                Name = name,
                Type = "ScaledInteger",
                Minimum = minimum,
                Maximum = maximum,
                Scale = scale,
                Offset = offset,
                Integers = values,
            };

        public static E57TestField Single(string name, params double[] values) =>
            new E57TestField { Name = name, Type = "Float", IsSingle = true, Reals = values };

        public static E57TestField Double(string name, params double[] values) =>
            new E57TestField { Name = name, Type = "Float", Reals = values };

        public int Count => Integers?.Length ?? Reals.Length;

        /// <summary>Bits of a value; 8 for the empty strings of string fields.</summary>
        public int Bits
        {
            get
            {
                if (Type == "String")
                    return 8;
                if (Type == "Float")
                    return IsSingle ? 32 : 64;
                ulong range = HasLimits ? (ulong)Maximum - (ulong)Minimum : ulong.MaxValue;
                int bits = 0;
                for (; range != 0; range >>= 1)
                    bits++;
                return bits;
            }
        }

        public ulong RawOf(int index)
        {
            if (Type == "String")
                return 0;
            if (Type == "Float")
                return IsSingle ? BitConverter.ToUInt32(BitConverter.GetBytes((float)Reals[index]), 0)
                    : BitConverter.ToUInt64(BitConverter.GetBytes(Reals[index]), 0);
            return (ulong)Integers[index] - (ulong)(HasLimits ? Minimum : long.MinValue);
        }

        public string Element()
        {
            if (Xml != null)
                return Xml;
            string text = "<" + Name + " type=\"" + Type + "\"";
            if (Type == "Float" && IsSingle)
                text += " precision=\"single\"";
            if (Type.EndsWith("Integer", StringComparison.Ordinal) && HasLimits)
                text += string.Format(CultureInfo.InvariantCulture, " minimum=\"{0}\" maximum=\"{1}\"", Minimum, Maximum);
            if (Type == "ScaledInteger")
                text += string.Format(CultureInfo.InvariantCulture, " scale=\"{0:R}\" offset=\"{1:R}\"", Scale, Offset);
            return text + "/>";
        }
    }

    public enum E57Packing
    {
        Even,

        /// <summary>Pieces of any length, some of them empty, so that streams run ahead of each other.</summary>
        Ragged,

        OneByOne,
    }
}
