using System.Collections.Generic;

namespace FastPoints.E57
{
    /// <summary>An element of the XML section: the tree of E57's own node types.</summary>
    sealed class E57Node
    {
        static readonly List<E57Node> s_none = new List<E57Node>();

        /// <summary>The name with its prefix, if it has one: "nor:normalX".</summary>
        public readonly string Name;

        /// <summary>Line of the XML section, for messages.</summary>
        public readonly int Line;

        /// <summary>Text between its tags; "" for none.</summary>
        public string Text = "";

        List<E57Node> m_children;
        List<KeyValuePair<string, string>> m_attributes;

        public E57Node(string name, int line)
        {
            Name = name;
            Line = line;
        }

        public IReadOnlyList<E57Node> Children => m_children ?? s_none;

        /// <summary>"Structure", "Integer", ...; null if the element does not say.</summary>
        public string Type => Attribute("type");

        public void Add(E57Node child) => (m_children ??= new List<E57Node>()).Add(child);

        public void AddAttribute(string name, string value) =>
            (m_attributes ??= new List<KeyValuePair<string, string>>()).Add(new KeyValuePair<string, string>(name, value));

        /// <returns>The attribute's text, or null.</returns>
        public string Attribute(string name)
        {
            if (m_attributes != null)
                foreach (var attribute in m_attributes)
                    if (attribute.Key == name)
                        return attribute.Value;
            return null;
        }

        /// <returns>The child of that name, or null.</returns>
        public E57Node Child(string name)
        {
            foreach (var child in Children)
                if (child.Name == name)
                    return child;
            return null;
        }

        /// <returns>A child's text in one line, or null if there is none.</returns>
        public string TextOf(string child)
        {
            string text = Child(child)?.Text;
            return string.IsNullOrWhiteSpace(text) ? null : E57Text.OneLine(text);
        }

        /// <summary>A child's number; an empty text means 0.</summary>
        /// <returns>NaN if there is no such child, or its text is not a number.</returns>
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
