using System;
using System.Collections.Generic;
using System.Text;
using FastPoints.Base;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>
    /// The JSON index of a source (Potree's cloud.js and metadata.json, ept.json), read whole, whose members are asked for by
    /// name; one that is missing or of another type is a failure that names the file and the member.
    /// </summary>
    internal sealed class SourceJson
    {
        /// <summary>A larger text is not parsed: its objects would take some 50 times its bytes.</summary>
        public const int MaxBytes = 4 << 20;

        readonly Dictionary<string, object> m_members;
        readonly string m_name;

        SourceJson(string path, long fileBytes, string name, Dictionary<string, object> members)
        {
            Path = path;
            FileBytes = fileBytes;
            m_name = name;
            m_members = members;
        }

        /// <summary>Of the file.</summary>
        public string Path { get; }

        /// <summary>Bytes of the file.</summary>
        public long FileBytes { get; }

        public IEnumerable<string> Names
        {
            get
            {
                foreach (string name in m_members.Keys)
                    yield return OneLine(name);
            }
        }

        /// <summary>Whether the first bytes of a file look like a JSON object, a byte order mark in front or not.</summary>
        public static bool Is(byte[] head)
        {
            int at = head.Length >= 3 && head[0] == 0xEF && head[1] == 0xBB && head[2] == 0xBF ? 3 : 0;
            while (at < head.Length && (head[at] == ' ' || head[at] >= 9 && head[at] <= 13))
                at++;
            if (at == head.Length || head[at] != '{')
                return false;
            for (int i = at; i < head.Length; i++)
                if (head[i] == 0)
                    return false;
            return true;
        }

        /// <summary>Reads and parses the file. Trailing commas are let through: such files are edited by hand.</summary>
        /// <exception cref="PointCloudException">It is no JSON object, or too long for an index.</exception>
        public static SourceJson Read(FileSource source)
        {
            if (source.Length > MaxBytes)
                throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, 0, "bytes of a JSON index",
                    "at most " + MaxBytes, source.Length);
            string text = Encoding.UTF8.GetString(source.ReadAtMost(0, (int)source.Length).Bytes).TrimStart('\uFEFF');
            try
            {
                return JsonReader.Parse(text, true) is Dictionary<string, object> members
                    ? new SourceJson(source.Path, source.Length, "", members)
                    : throw new FormatException("wanted an object");
            }
            catch (FormatException e)
            {
                throw new PointCloudException(FailureCode.BadInput, source.Path, 0, "no JSON: " + e.Message, e);
            }
        }

        public bool Has(string name) => m_members.ContainsKey(name);

        public bool IsObject(string name) => Member(name) is Dictionary<string, object>;

        public bool IsText(string name) => Member(name) is string;

        public SourceJson Object(string name) => ToObject(Member(name), name);

        /// <summary>A member that must be text. Control characters become blanks: it is shown to people as one line.</summary>
        public string Text(string name) => Member(name) is string text ? OneLine(text) : throw Bad(name, "text");

        /// <summary>Text, or what stands in where there is none.</summary>
        public string Text(string name, string otherwise) => Member(name) is string text ? OneLine(text) : otherwise;

        /// <summary>A member that must be a finite number.</summary>
        public double Number(string name) => ToNumber(Member(name), name);

        public double Number(string name, double otherwise) => Has(name) ? Number(name) : otherwise;

        public long Whole(string name)
        {
            try
            {
                return JsonReader.ToLong(Member(name));
            }
            catch (FormatException)
            {
                throw Bad(name, "a whole number");
            }
        }

        public long Whole(string name, long otherwise) => Has(name) ? Whole(name) : otherwise;

        /// <summary>A member that must be a list.</summary>
        public List<object> List(string name) => Member(name) as List<object> ?? throw Bad(name, "a list");

        public bool IsList(string name) => Member(name) is List<object>;

        /// <summary>A list of objects.</summary>
        public List<SourceJson> Objects(string name)
        {
            var objects = new List<SourceJson>();
            foreach (object item in List(name))
                objects.Add(ToObject(item, name + "[" + NumberText.Of(objects.Count) + "]"));
            return objects;
        }

        /// <summary>Whether <see cref="Numbers"/> would give so many.</summary>
        public bool IsNumbers(string name, int count)
        {
            if (!(Member(name) is List<object> list) || list.Count != count)
                return false;
            foreach (object item in list)
                if (!JsonReader.IsNumber(item))
                    return false;
            return true;
        }

        /// <summary>A list of finite numbers, exactly so many.</summary>
        public double[] Numbers(string name, int count)
        {
            var list = List(name);
            if (list.Count != count)
                throw Bad(name, NumberText.Of(count) + " numbers");
            var numbers = new double[count];
            for (int i = 0; i < count; i++)
                numbers[i] = ToNumber(list[i], name);
            return numbers;
        }

        /// <summary>A list of three finite numbers.</summary>
        public double3 Vector(string name)
        {
            double[] numbers = Numbers(name, 3);
            return new double3(numbers[0], numbers[1], numbers[2]);
        }

        /// <summary>The failure of a member that is not what it must be.</summary>
        public PointCloudException Bad(string name, string wanted) => PointCloudException.Wanted(FailureCode.BadInput, Path, -1,
            "\"" + m_name + name + "\"", wanted, Has(name) ? Shown(Member(name)) : "nothing of that name");

        object Member(string name) => m_members.TryGetValue(name, out object value) ? value : null;

        SourceJson ToObject(object value, string name) => value is Dictionary<string, object> members
            ? new SourceJson(Path, FileBytes, m_name + name + ".", members)
            : throw Bad(name, "an object");

        double ToNumber(object value, string name)
        {
            double number;
            try
            {
                number = JsonReader.ToDouble(value);
            }
            catch (FormatException)
            {
                throw Bad(name, "a number");
            }
            return double.IsNaN(number) || double.IsInfinity(number) ? throw Bad(name, "a finite number") : number;
        }

        /// <summary>Text without control characters, for messages and names.</summary>
        public static string OneLine(string text)
        {
            char[] line = text.ToCharArray();
            for (int i = 0; i < line.Length; i++)
                if (char.IsControl(line[i]))
                    line[i] = ' ';
            return new string(line);
        }

        static string Shown(object value)
        {
            switch (value)
            {
                case null: return "null";
                case string text: return "\"" + OneLine(text) + "\"";
                case bool flag: return flag ? "true" : "false";
                case List<object> list: return "a list of " + NumberText.Of(list.Count);
                case Dictionary<string, object> _: return "an object";
                default: return "another number";
            }
        }
    }
}
