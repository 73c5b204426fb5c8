using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints
{
    // Typed members of a JSON object; a failure names the file and the member.
    internal sealed class JsonMembers
    {
        readonly Dictionary<string, object> m_members;
        readonly string m_prefix = "";
        readonly bool m_isForeign;

        JsonMembers(Dictionary<string, object> members, string path, bool isForeign, long fileBytes) =>
            (m_members, m_isForeign, Path, FileBytes) = (members, isForeign, path, fileBytes);

        JsonMembers(Dictionary<string, object> members, JsonMembers parent, string name)
            : this(members, parent.Path, parent.m_isForeign, parent.FileBytes)
        {
            // Files of the package have no ambiguous names.
            if (m_isForeign)
                m_prefix = parent.m_prefix + name + ".";
        }

        public string Path { get; }
        public long FileBytes { get; }

        public IEnumerable<string> Names
        {
            get
            {
                foreach (string name in m_members.Keys)
                    yield return Shown(name);
            }
        }

        // Foreign files may have trailing commas, as they are edited by hand, and control characters, which become blanks: text
        // is shown to people as one line.
        public static JsonMembers Parse(string text, string path, bool isForeign = false, long fileBytes = 0)
        {
            try
            {
                return JsonReader.Parse(text, isForeign) is Dictionary<string, object> members
                    ? new JsonMembers(members, path, isForeign, fileBytes)
                    : throw new FormatException("wanted an object");
            }
            catch (FormatException e)
            {
                throw new PointCloudException(FailureCode.BadInput, path, -1, "no JSON: " + e.Message, e);
            }
        }

        public bool Has(string name) => m_members.ContainsKey(name);

        public bool IsObject(string name) => Find(name) is Dictionary<string, object>;

        public bool IsText(string name) => Find(name) is string;

        public bool IsList(string name) => Find(name) is List<object>;

        public bool IsNumbers(string name, int count) =>
            Find(name) is List<object> list && list.Count == count && list.TrueForAll(JsonReader.IsNumber);

        public long Long(string name) => Read(name, JsonReader.ToLong);

        public long Long(string name, long fallback) => Has(name) ? Long(name) : fallback;

        public int Int(string name) => Read(name, v => (int)InRange(v, int.MinValue, int.MaxValue));

        public long NonNegative(string name, long max = long.MaxValue) => Read(name, v => InRange(v, 0, max));

        public ulong Hex(string name) => Read(name, JsonReader.FromHex);

        // NaN for null: JSON has no word for it.
        public double NumberOrNaN(string name) => Read(name, v => v == null ? double.NaN : JsonReader.ToDouble(v));

        public double Number(string name) => Read(name, Finite);

        public double Number(string name, double fallback) => Has(name) ? Number(name) : fallback;

        public string Text(string name) => Shown(Read(name, JsonReader.ToText));

        public string Text(string name, string fallback) => IsText(name) ? Text(name) : fallback;

        public string TextOrNull(string name) => Find(name) == null ? null : Text(name);

        public bool Flag(string name) => Has(name) &&
            Read(name, v => v is bool flag ? flag : throw new FormatException("wanted true or false"));

        public List<object> List(string name) =>
            Read(name, v => v as List<object> ?? throw new FormatException("wanted a list, got " + JsonReader.Describe(v)));

        public List<string> Texts(string name) => Read(name, _ => List(name).ConvertAll(i => Shown(JsonReader.ToText(i))));

        public double[] Numbers(string name, int count)
        {
            var list = List(name);
            return list.Count == count
                ? Read(name, _ => list.ConvertAll(Finite)).ToArray()
                : throw Failure(name, "wanted " + NumberText.Of(count) + " numbers, got a list of " + NumberText.Of(list.Count));
        }

        // Exactly count numbers, unless it is negative.
        public long[] Longs(string name, int count = -1) => Read(name, v => ToLongs(v, count));

        public List<long[]> LongLists(string name, int count) => Read(name, _ => List(name).ConvertAll(i => ToLongs(i, count)));

        public double3 Vector(string name)
        {
            double[] numbers = Numbers(name, 3);
            return new double3(numbers[0], numbers[1], numbers[2]);
        }

        public JsonMembers Object(string name) => ToObject(Find(name), name);

        public JsonMembers ObjectOrNull(string name) => Find(name) == null ? null : Object(name);

        public List<JsonMembers> Objects(string name)
        {
            int at = 0;
            return List(name).ConvertAll(i => ToObject(i, name + "[" + NumberText.Of(at++) + "]"));
        }

        public void RequireVersion(long wanted)
        {
            long got = Long("version");
            if (got != wanted)
                throw PointCloudException.Wanted(FailureCode.Unsupported, Path, -1, "\"version\"", wanted, got);
        }

        public PointCloudException Wanted(string name, string wanted) =>
            Failure(name, Has(name) ? "wanted " + wanted + ", got " + JsonReader.Describe(Find(name)) : "missing");

        public PointCloudException Failure(string name, string what, Exception inner = null) =>
            new PointCloudException(FailureCode.BadInput, Path, -1, "\"" + m_prefix + name + "\": " + what, inner);

        object Find(string name) => m_members.TryGetValue(name, out object value) ? value : null;

        T Read<T>(string name, Func<object, T> read)
        {
            if (!m_members.TryGetValue(name, out object value))
                throw Failure(name, "missing");
            try
            {
                return read(value);
            }
            catch (FormatException e)
            {
                throw Failure(name, e.Message, e);
            }
        }

        JsonMembers ToObject(object value, string name) => value is Dictionary<string, object> members
            ? new JsonMembers(members, this, name) : throw Failure(name,
            value == null && !Has(name) ? "missing" : "wanted an object, got " + JsonReader.Describe(value));

        string Shown(string text) => m_isForeign ? JsonReader.OneLine(text) : text;

        static long InRange(object value, long min, long max)
        {
            long number = JsonReader.ToLong(value);
            return number >= min && number <= max ? number : throw new FormatException("wanted " + NumberText.Of(min) +
                " to " + NumberText.Of(max) + ", got " + NumberText.Of(number));
        }

        static long[] ToLongs(object value, int count) =>
            value is List<object> list && (count < 0 || list.Count == count)
                ? list.ConvertAll(JsonReader.ToLong).ToArray()
                : throw new FormatException("wanted a list of " + (count < 0 ? "" : NumberText.Of(count) + " ") +
                    "whole numbers, got " + JsonReader.Describe(value));

        static double Finite(object value)
        {
            double number = JsonReader.ToDouble(value);
            return double.IsInfinity(number) ? throw new FormatException("wanted a finite number") : number;
        }
    }
}
