using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using System.Xml;

namespace FastPoints.E57
{
    // Prefixes need not be declared (some writers forget to). Document type definitions, and with them entities, are refused, and
    // a document's use of memory is bounded.
    static class E57XmlTree
    {
        public const int MaxBytes = 32 << 20;

        // Elements and attributes: about 100 bytes each.
        const int MaxItems = 1_000_000;
        const int MaxDepth = 64;

        // Between two tags: the parser holds all attributes of a tag together.
        const int MaxTagBytes = 1 << 20;
        const int MaxTextChars = 1 << 20;

        public static E57Node Parse(byte[] xml, string path, long offset)
        {
            CheckTags(xml, path, offset);
            try
            {
                using var text = new StreamReader(new MemoryStream(xml), Encoding.UTF8);
                using var reader = new XmlTextReader(text)
                {
                    Namespaces = false,
                    DtdProcessing = DtdProcessing.Prohibit,
                    XmlResolver = null,
                    WhitespaceHandling = WhitespaceHandling.None,
                    // Without definitions there are no entities to expand: a named one is an error.
                    EntityHandling = EntityHandling.ExpandEntities,
                };
                return Parse(reader, path, offset);
            }
            catch (XmlException e)
            {
                throw new PointCloudException(FailureCode.BadInput, path, offset, "the XML section, line " + e.LineNumber +
                    ", column " + e.LinePosition + ": " + E57Text.OneLine(e.Message), e);
            }
        }

        static E57Node Parse(XmlTextReader reader, string path, long offset)
        {
            var open = new Stack<E57Node>();
            var leafText = new StringBuilder();
            E57Node root = null;
            int items = 0;
            while (reader.Read())
            {
                switch (reader.NodeType)
                {
                    case XmlNodeType.Element:
                        items += 1 + reader.AttributeCount;
                        if (items > MaxItems || open.Count == MaxDepth)
                            throw PointCloudException.Wanted(FailureCode.Unsupported, path, offset, "the XML section",
                                "at most " + MaxItems + " elements and attributes, nested at most " + MaxDepth + " deep",
                                "more");
                        var node = new E57Node(reader.Name, reader.LineNumber);
                        bool isEmpty = reader.IsEmptyElement;
                        while (reader.MoveToNextAttribute())
                            node.AddAttribute(reader.Name, reader.Value);
                        if (open.Count > 0)
                            open.Peek().Add(node);
                        root = root ?? node;
                        leafText.Clear();
                        if (!isEmpty)
                            open.Push(node);
                        break;
                    case XmlNodeType.EndElement:
                        var ended = open.Pop();
                        if (ended.Children.Count == 0)
                            ended.Text = leafText.ToString();
                        leafText.Clear();
                        break;
                    case XmlNodeType.Text:
                    case XmlNodeType.CDATA:
                        if (leafText.Length + reader.Value.Length > MaxTextChars)
                            throw PointCloudException.Wanted(FailureCode.Unsupported, path, offset, "text of the XML section",
                                "at most " + MaxTextChars + " characters", "more");
                        leafText.Append(reader.Value);
                        break;
                }
            }
            return root ?? throw new PointCloudException(FailureCode.BadInput, path, offset, "the XML section has no element");
        }

        static void CheckTags(byte[] xml, string path, long offset)
        {
            int last = 0;
            for (int i = 0; i < xml.Length; i++)
            {
                if (xml[i] != '<')
                {
                    if (i - last > MaxTagBytes)
                        throw PointCloudException.Wanted(FailureCode.Unsupported, path, offset, "a tag of the XML section",
                            "at most " + MaxTagBytes + " bytes with the text behind it", "more");
                    continue;
                }
                last = i;
            }
        }
    }

    sealed class E57Node
    {
        static readonly List<E57Node> s_none = new List<E57Node>();
        public readonly string Name; // With its prefix, if it has one: "nor:normalX".

        public readonly int Line;
        public string Text = "";

        List<E57Node> m_children;
        List<KeyValuePair<string, string>> m_attributes;

        public E57Node(string name, int line)
        {
            Name = name;
            Line = line;
        }

        public IReadOnlyList<E57Node> Children => m_children ?? s_none;
        public string Type => Attribute("type"); // "Structure", "Integer", ...; null if the element does not say.

        public void Add(E57Node child) => (m_children ??= new List<E57Node>()).Add(child);

        public void AddAttribute(string name, string value) =>
            (m_attributes ??= new List<KeyValuePair<string, string>>()).Add(new KeyValuePair<string, string>(name, value));

        public string Attribute(string name)
        {
            if (m_attributes != null)
                foreach (var attribute in m_attributes)
                    if (attribute.Key == name)
                        return attribute.Value;
            return null;
        }

        public E57Node Child(string name)
        {
            foreach (var child in Children)
                if (child.Name == name)
                    return child;
            return null;
        }

        public string TextOf(string child)
        {
            string text = Child(child)?.Text;
            return string.IsNullOrWhiteSpace(text) ? null : E57Text.OneLine(text);
        }

        // NaN if there is no such child, or its text is not a number; an empty text means 0.
        public double NumberOf(string child)
        {
            var node = Child(child);
            if (node == null)
                return double.NaN;
            if (!E57Text.TryReal(node.Text, 0, out double value))
                return double.NaN;
            if (node.Type != "ScaledInteger")
                return value;
            E57Text.TryReal(node.Attribute("scale"), 1, out double scale);
            E57Text.TryReal(node.Attribute("offset"), 0, out double offset);
            return value * scale + offset;
        }

        public override string ToString() => Name + ":" + Type + " " + Text;
    }

    static class E57Text
    {
        const int MaxShownChars = 400;

        static readonly DateTime s_gpsEpoch = new DateTime(1980, 1, 6, 0, 0, 0, DateTimeKind.Utc);

        public static bool TryInteger(string text, long missing, out long value)
        {
            value = missing;
            if (string.IsNullOrWhiteSpace(text))
                return true;
            return long.TryParse(text.Trim(), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value);
        }

        public static bool TryReal(string text, double missing, out double value)
        {
            value = missing;
            if (string.IsNullOrWhiteSpace(text))
                return true;
            return NumberText.TryRead(text.Trim(), out value);
        }

        public static bool TryCount(string text, out ulong value) =>
            ulong.TryParse(text?.Trim(), NumberStyles.None, CultureInfo.InvariantCulture, out value);

        // No line ends, nothing unprintable, not longer than a few lines.
        public static string OneLine(string text)
        {
            var line = new StringBuilder(Math.Min(text.Length, MaxShownChars));
            bool isBlank = true;
            foreach (char c in text)
            {
                if (line.Length == MaxShownChars)
                    return line.Append("...").ToString();
                bool isSpace = char.IsWhiteSpace(c) || char.IsControl(c);
                if (isSpace && isBlank)
                    continue;
                line.Append(isSpace ? ' ' : c);
                isBlank = isSpace;
            }
            return line.ToString().TrimEnd();
        }

        // A dateTimeValue: GPS time counts no leap seconds.
        public static string GpsTime(double seconds) =>
            seconds > 0 && seconds < 1e10
                ? s_gpsEpoch.AddSeconds(seconds).ToString("yyyy-MM-dd HH:mm:ss", CultureInfo.InvariantCulture) + " GPS time"
                : NumberText.Of(seconds) + " s of GPS time";
    }
}
