using System;
using System.Collections.Generic;
using FastPoints.Base;

namespace FastPoints.Editor
{
    /// <summary>Members of a JSON object, each as what it must be. What is missing or of another kind is told with its name and
    /// the file's.</summary>
    sealed class JsonMembers
    {
        readonly Dictionary<string, object> m_members;
        readonly string m_path;

        JsonMembers(object value, string path)
        {
            m_members = value as Dictionary<string, object> ?? throw new FormatException("wanted an object");
            m_path = path;
        }

        /// <exception cref="PointCloudException">It is no JSON object.</exception>
        public static JsonMembers Parse(string text, string path) =>
            Guarded("", path, () => new JsonMembers(JsonReader.Parse(text), path));

        public long Long(string name) => Member(name, JsonReader.ToLong);

        public ulong Hex(string name) => Member(name, JsonReader.ToHex);

        /// <summary>NaN for null: JSON has no word for it.</summary>
        public double Double(string name) => Member(name, v => v == null ? double.NaN : JsonReader.ToDouble(v));

        public string Text(string name) => Member(name, v => v as string ?? throw new FormatException("wanted a string"));

        /// <summary>A string, or null where it is null or not there.</summary>
        public string TextOrNull(string name) =>
            m_members.TryGetValue(name, out object value) && value != null ? Text(name) : null;

        public bool Has(string name) => m_members.ContainsKey(name);

        /// <summary>False where there is no such member.</summary>
        public bool Flag(string name) => Has(name) &&
            Member(name, v => v is bool flag ? flag : throw new FormatException("wanted true or false"));

        public List<string> Texts(string name) =>
            Items(name).ConvertAll(i => i as string ?? throw Wrong(name, m_path, "wanted strings", null));

        public List<double> Doubles(string name) =>
            Items(name).ConvertAll(i => Guarded(name, m_path, () => JsonReader.ToDouble(i)));

        public List<JsonMembers> Objects(string name) =>
            Items(name).ConvertAll(i => Guarded(name, m_path, () => new JsonMembers(i, m_path)));

        /// <summary>An object, or null where it is null or not there.</summary>
        public JsonMembers ObjectOrNull(string name) => m_members.TryGetValue(name, out object value) && value != null
            ? Guarded(name, m_path, () => new JsonMembers(value, m_path))
            : null;

        /// <summary>Checks a version, and says what to do about another one.</summary>
        public void NeedVersion(long wanted)
        {
            long got = Long("version");
            if (got != wanted)
                throw PointCloudException.Wanted(FailureCode.Unsupported, m_path, -1, "\"version\"", wanted, got);
        }

        /// <summary>What is wrong with a member.</summary>
        public PointCloudException Wrong(string name, string what) => Wrong(name, m_path, what, null);

        List<object> Items(string name) => Member(name, v => v as List<object> ?? throw new FormatException("wanted an array"));

        T Member<T>(string name, Func<object, T> read) => m_members.TryGetValue(name, out object value)
            ? Guarded(name, m_path, () => read(value))
            : throw Wrong(name, m_path, "missing", null);

        static T Guarded<T>(string name, string path, Func<T> read)
        {
            try
            {
                return read();
            }
            catch (FormatException e)
            {
                throw Wrong(name, path, e.Message, e);
            }
        }

        static PointCloudException Wrong(string name, string path, string what, Exception inner) =>
            new PointCloudException(FailureCode.BadInput, path, -1, (name.Length > 0 ? "\"" + name + "\": " : "") + what, inner);
    }
}
