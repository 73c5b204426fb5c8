using System.Collections.Generic;

namespace FastPoints.Reading
{
    // One KEYWORD[...] of well-known text (OGC 01-009, ISO 19162).
    internal sealed class WktNode
    {
        // Text that is nested deeper than any CRS is not followed.
        const int MaxDepth = 64;

        public readonly string Keyword;
        public readonly List<string> Values = new List<string>();
        public readonly List<WktNode> Children = new List<WktNode>();

        WktNode(string keyword) => Keyword = keyword;

        // The outermost node, or null. Text that breaks off gives what comes before.
        public static WktNode Parse(string text)
        {
            var open = new Stack<WktNode>();
            WktNode root = null;
            int at = 0;
            while (at < text.Length)
            {
                char c = text[at];
                if (c == '"')
                {
                    int end = at + 1;
                    while (end < text.Length && (text[end] != '"' || end + 1 < text.Length && text[end + 1] == '"'))
                        end += text[end] == '"' ? 2 : 1;
                    end = end < text.Length ? end : text.Length;
                    if (open.Count > 0)
                        open.Peek().Values.Add(text.Substring(at + 1, end - at - 1).Replace("\"\"", "\""));
                    at = end + 1;
                }
                else if (c == ']' || c == ')')
                {
                    if (open.Count > 0)
                        open.Pop();
                    if (open.Count == 0)
                        return root;
                    at++;
                }
                else if (IsPlain(c))
                {
                    int end = at;
                    while (end < text.Length && IsPlain(text[end]))
                        end++;
                    string word = text.Substring(at, end - at);
                    while (end < text.Length && char.IsWhiteSpace(text[end]))
                        end++;
                    at = end;
                    if (end == text.Length || text[end] != '[' && text[end] != '(')
                    {
                        if (open.Count > 0)
                            open.Peek().Values.Add(word);
                        continue;
                    }
                    if (open.Count == MaxDepth)
                        return root;
                    var node = new WktNode(word.ToUpperInvariant());
                    if (open.Count > 0)
                        open.Peek().Children.Add(node);
                    root = root ?? node;
                    open.Push(node);
                    at++;
                }
                else
                {
                    at++;
                }
            }
            return root;
        }

        public WktNode Child(params string[] keywords)
        {
            foreach (var child in Children)
                if (System.Array.IndexOf(keywords, child.Keyword) >= 0)
                    return child;
            return null;
        }

        static bool IsPlain(char c) => char.IsLetterOrDigit(c) || c == '_' || c == '.' || c == '-' || c == '+';
    }
}
