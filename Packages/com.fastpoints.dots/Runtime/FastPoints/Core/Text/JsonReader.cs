using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace FastPoints
{
    // A strict reader of small JSON texts (RFC 8259): objects become dictionaries and arrays lists. Numbers stay text until
    // they are converted, so that 64-bit counts are exact. Players should carry no JSON library, and Unity's fills the fields
    // of a class without saying what was missing or had the wrong type.
    internal sealed class JsonReader
    {
        const int MaxDepth = 64;

        sealed class Number
        {
            public string Text;
        }

        readonly string m_text;
        readonly bool m_allowsTrailingCommas;
        int m_at;

        JsonReader(string text, bool allowsTrailingCommas) => (m_text, m_allowsTrailingCommas) = (text, allowsTrailingCommas);

        // Dictionary, List, string, bool, null, or a number for ToLong and ToDouble. A FormatException says where it is none.
        public static object Parse(string text, bool allowTrailingCommas = false)
        {
            var reader = new JsonReader(text, allowTrailingCommas);
            object value = reader.Value(0);
            reader.SkipSpace();
            if (reader.m_at != text.Length)
                throw reader.Unexpected("nothing more");
            return value;
        }

        public static long ToLong(object value) =>
            value is Number n && long.TryParse(n.Text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture,
                out long result)
                ? result
                : throw new FormatException("wanted a whole number, got " + Describe(value));

        public static double ToDouble(object value) =>
            value is Number n && NumberText.TryRead(n.Text, out double result)
                ? result
                : throw new FormatException("wanted a number, got " + Describe(value));

        public static ulong FromHex(object value) =>
            value is string text && text.Length == 16 &&
            ulong.TryParse(text, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out ulong result)
                ? result
                : throw new FormatException("wanted 16 hexadecimal digits in a string, got " + Describe(value));

        public static bool IsNumber(object value) =>
            value is Number n && NumberText.TryRead(n.Text, out double result) && !double.IsInfinity(result);

        public static string ToText(object value) =>
            value as string ?? throw new FormatException("wanted text, got " + Describe(value));

        public static string Describe(object value) => value switch
        {
            null => "null",
            Number n => n.Text,
            string s => "\"" + OneLine(s) + "\"",
            bool b => b ? "true" : "false",
            _ => value is List<object> ? "a list" : "an object",
        };

        // Text without control characters, for messages and names.
        public static string OneLine(string text)
        {
            char[] line = text.ToCharArray();
            for (int i = 0; i < line.Length; i++)
                if (char.IsControl(line[i]))
                    line[i] = ' ';
            return new string(line);
        }

        object Value(int depth)
        {
            if (depth > MaxDepth)
                throw Unexpected("fewer levels");
            SkipSpace();
            return (m_at < m_text.Length ? m_text[m_at] : '\0') switch
            {
                '{' => Object(depth),
                '[' => Array(depth),
                '"' => String(),
                't' => Literal("true", true),
                'f' => Literal("false", false),
                'n' => Literal("null", null),
                _ => ReadNumber(),
            };
        }

        Dictionary<string, object> Object(int depth)
        {
            var members = new Dictionary<string, object>();
            m_at++;
            if (TryTake('}'))
                return members;
            do
            {
                if (IsTrailing('}'))
                    break;
                SkipSpace();
                string name = String();
                Require(':');
                if (!members.TryAdd(name, Value(depth + 1)))
                    throw Unexpected("one \"" + name + "\"");
            }
            while (TryTake(','));
            Require('}');
            return members;
        }

        List<object> Array(int depth)
        {
            var items = new List<object>();
            m_at++;
            if (TryTake(']'))
                return items;
            do
            {
                if (IsTrailing(']'))
                    break;
                items.Add(Value(depth + 1));
            }
            while (TryTake(','));
            Require(']');
            return items;
        }

        string String()
        {
            if (m_at >= m_text.Length || m_text[m_at] != '"')
                throw Unexpected("a string");
            m_at++;
            var result = new StringBuilder();
            while (m_at < m_text.Length && m_text[m_at] != '"')
            {
                char c = m_text[m_at++];
                if (c < ' ')
                    throw Unexpected("no control character");
                result.Append(c == '\\' ? Escaped() : c);
            }
            if (m_at >= m_text.Length)
                throw Unexpected("an end of the string");
            m_at++;
            return result.ToString();
        }

        char Escaped()
        {
            char c = m_at < m_text.Length ? m_text[m_at++] : '\0';
            switch (c)
            {
                case '"': case '\\': case '/': return c;
                case 'b': return '\b';
                case 'f': return '\f';
                case 'n': return '\n';
                case 'r': return '\r';
                case 't': return '\t';
                case 'u':
                    if (m_at + 4 <= m_text.Length && ushort.TryParse(m_text.Substring(m_at, 4), NumberStyles.AllowHexSpecifier,
                        CultureInfo.InvariantCulture, out ushort code))
                    {
                        m_at += 4;
                        return (char)code;
                    }
                    break;
            }
            throw Unexpected("an escape");
        }

        object ReadNumber()
        {
            int start = m_at;
            if (m_at < m_text.Length && m_text[m_at] == '-')
                m_at++;
            int whole = m_at;
            bool digits = Digits();
            if (digits && m_text[whole] == '0' && m_at - whole > 1)
                digits = false;
            if (digits && m_at < m_text.Length && m_text[m_at] == '.')
            {
                m_at++;
                digits = Digits();
            }
            if (digits && m_at < m_text.Length && (m_text[m_at] == 'e' || m_text[m_at] == 'E'))
            {
                m_at++;
                if (m_at < m_text.Length && (m_text[m_at] == '+' || m_text[m_at] == '-'))
                    m_at++;
                digits = Digits();
            }
            if (!digits)
                throw Unexpected("a value");
            return new Number { Text = m_text.Substring(start, m_at - start) };
        }

        bool Digits()
        {
            int start = m_at;
            while (m_at < m_text.Length && m_text[m_at] >= '0' && m_text[m_at] <= '9')
                m_at++;
            return m_at > start;
        }

        object Literal(string word, object value)
        {
            if (string.CompareOrdinal(m_text, m_at, word, 0, word.Length) != 0)
                throw Unexpected("a value");
            m_at += word.Length;
            return value;
        }

        bool TryTake(char c)
        {
            SkipSpace();
            if (m_at >= m_text.Length || m_text[m_at] != c)
                return false;
            m_at++;
            return true;
        }

        // Whether the comma just read ended its object or array, and may do so.
        bool IsTrailing(char end)
        {
            if (!m_allowsTrailingCommas)
                return false;
            SkipSpace();
            return m_at < m_text.Length && m_text[m_at] == end;
        }

        void Require(char c)
        {
            if (!TryTake(c))
                throw Unexpected("'" + c + "'");
        }

        void SkipSpace()
        {
            while (m_at < m_text.Length && (m_text[m_at] == ' ' || m_text[m_at] == '\n' || m_text[m_at] == '\r' ||
                m_text[m_at] == '\t'))
                m_at++;
        }

        FormatException Unexpected(string wanted) =>
            new FormatException(string.Format(CultureInfo.InvariantCulture, "at character {0}: wanted {1}, got {2}", m_at, wanted,
                m_at >= m_text.Length ? "the end"
                    : char.IsControl(m_text[m_at]) ? "U+" + ((int)m_text[m_at]).ToString("X4", CultureInfo.InvariantCulture)
                    : "'" + m_text[m_at] + "'"));
    }
}
