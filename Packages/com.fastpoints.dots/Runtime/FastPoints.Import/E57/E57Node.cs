using System.Collections.Generic;

namespace FastPoints.E57
{
    sealed class E57Node
    {
        static readonly List<E57Node> s_none = new List<E57Node>();

        // With its prefix, if it has one: "nor:normalX".
        public readonly string Name;

        // Of the XML section, for messages.
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

        // "Structure", "Integer", ...; null if the element does not say.
        public string Type => Attribute("type");

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

        // In one line; null if there is none.
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
}
