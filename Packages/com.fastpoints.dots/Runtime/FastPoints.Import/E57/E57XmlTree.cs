using System.Collections.Generic;
using System.IO;
using System.Text;
using System.Xml;
using FastPoints.Core;

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
}
