using System.Globalization;
using System.Text;

namespace FastPoints
{
    // JSON for people: two spaces a level, arrays of numbers on one line, doubles with enough digits to read back the same.
    internal sealed class JsonWriter
    {
        readonly StringBuilder m_text = new StringBuilder();
        int m_depth;
        bool m_isFirst = true;
        bool m_isBegun;

        public JsonWriter BeginObject(string name = null) => Open(name, '{');

        public JsonWriter EndObject() => Close('}');

        public JsonWriter BeginArray(string name = null) => Open(name, '[');

        public JsonWriter EndArray() => Close(']');

        public JsonWriter Add(string name, string value) => Raw(name, value == null ? "null" : Quoted(value));

        public JsonWriter Add(string name, long value) => Raw(name, NumberText.Of(value));

        public JsonWriter Add(string name, bool value) => Raw(name, value ? "true" : "false");

        // Null if the value is not finite: JSON has no word for that.
        public JsonWriter Add(string name, double value) => Raw(name, Text(value));

        public JsonWriter Add(string name, double x, double y, double z) =>
            Raw(name, "[" + Text(x) + ", " + Text(y) + ", " + Text(z) + "]");

        public JsonWriter Add(string name, long x, long y, long z) =>
            Raw(name, string.Format(CultureInfo.InvariantCulture, "[{0}, {1}, {2}]", x, y, z));

        // Sixteen hexadecimal digits as a string, which readers that only know doubles do not round.
        public JsonWriter AddHex(string name, ulong value) => Add(name, value.ToString("x16", CultureInfo.InvariantCulture));

        public override string ToString() => m_text + "\n";

        // What was written since the last call: of a text that is too long to be held.
        public string Take()
        {
            string text = m_text.ToString();
            m_text.Clear();
            return text;
        }

        static string Text(double value) => double.IsNaN(value) || double.IsInfinity(value) ? "null" : NumberText.Of(value);

        static string Quoted(string value)
        {
            var text = new StringBuilder("\"");
            foreach (char c in value)
            {
                if (c == '"' || c == '\\')
                    text.Append('\\').Append(c);
                else if (c < ' ')
                    text.Append("\\u").Append(((int)c).ToString("x4", CultureInfo.InvariantCulture));
                else
                    text.Append(c);
            }
            return text.Append('"').ToString();
        }

        JsonWriter Raw(string name, string value)
        {
            NextLine(name);
            m_text.Append(value);
            return this;
        }

        JsonWriter Open(string name, char bracket)
        {
            NextLine(name);
            m_text.Append(bracket);
            m_depth++;
            m_isFirst = true;
            return this;
        }

        JsonWriter Close(char bracket)
        {
            m_depth--;
            if (!m_isFirst)
                m_text.Append('\n').Append(' ', m_depth * 2);
            m_text.Append(bracket);
            m_isFirst = false;
            return this;
        }

        void NextLine(string name)
        {
            if (m_isBegun)
                m_text.Append(m_isFirst ? "\n" : ",\n").Append(' ', m_depth * 2);
            m_isFirst = false;
            m_isBegun = true;
            if (name != null)
                m_text.Append(Quoted(name)).Append(": ");
        }
    }
}
