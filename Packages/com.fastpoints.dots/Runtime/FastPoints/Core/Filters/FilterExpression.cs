using System;
using System.Collections.Generic;

namespace FastPoints
{
    internal enum FilterOp
    {
        Equal,
        NotEqual,
        Less,
        LessOrEqual,
        Greater,
        GreaterOrEqual,
        Not,
        And,
        Or,
    }

    /// <summary>A number, or an attribute's value. Blittable once it is bound to a batch.</summary>
    internal struct FilterOperand
    {
        public bool IsAttribute;
        public PointColumn Column;
        public double Scale; // For an attribute: value = stored * Scale + Offset.
        public double Offset;
        public double Number;
    }

    /// <summary>A comparison, which pushes its result on a stack, or an operation on results there. Blittable.</summary>
    internal struct FilterStep
    {
        public FilterOp Op;
        public FilterOperand Left;
        public FilterOperand Right;
        public double RelativeTolerance; // Values that differ only by rounding of the scale are equal.
        public double AbsoluteTolerance;
    }

    /// <summary>A condition on attributes, such as <c>Intensity > 100 &amp;&amp; !(Classification == 2)</c>: comparisons of
    /// names and numbers, joined by &amp;&amp;, || (which binds less), ! and parentheses.</summary>
    internal sealed class FilterExpression
    {
        public const int MaxDepth = 32;
        public const int MaxSteps = 1024;

        static readonly string[] s_comparisons = { "==", "!=", "<=", ">=", "<", ">" };
        static readonly FilterOp[] s_ops =
        {
            FilterOp.Equal, FilterOp.NotEqual, FilterOp.LessOrEqual, FilterOp.GreaterOrEqual, FilterOp.Less, FilterOp.Greater,
        };

        int m_at;

        FilterExpression(string text)
        {
            Text = text;
            Or(0);
            SkipSpace();
            if (m_at < text.Length)
                throw Bad("&&, || or the end", m_at);
        }

        public string Text { get; }

        /// <summary>In order of evaluation; the last leaves one result.</summary>
        public List<FilterStep> Steps { get; } = new List<FilterStep>();

        /// <summary>Names of the left and right operands of each step; null for numbers.</summary>
        public List<(string Left, string Right)> Names { get; } = new List<(string, string)>();

        /// <exception cref="FormatException">Its message says what was expected, and marks the column in a line below
        /// the text.</exception>
        public static FilterExpression Parse(string text) => new FilterExpression(text);

        void Or(int depth)
        {
            And(depth);
            while (Take("||"))
            {
                And(depth);
                Add(new FilterStep { Op = FilterOp.Or }, null, null);
            }
        }

        void And(int depth)
        {
            Term(depth);
            while (Take("&&"))
            {
                Term(depth);
                Add(new FilterStep { Op = FilterOp.And }, null, null);
            }
        }

        void Term(int depth)
        {
            if (depth > MaxDepth)
                throw Bad("at most " + MaxDepth + " parentheses and ! within one another", m_at);
            SkipSpace();
            if (m_at < Text.Length && Text[m_at] == '!')
            {
                m_at++;
                Term(depth + 1);
                Add(new FilterStep { Op = FilterOp.Not }, null, null);
            }
            else if (Take("("))
            {
                Or(depth + 1);
                if (!Take(")"))
                    throw Bad(")", m_at);
            }
            else
            {
                Comparison();
            }
        }

        void Comparison()
        {
            var step = new FilterStep { Left = Operand(out string left) };
            int op = Array.FindIndex(s_comparisons, Take);
            if (op < 0)
                throw Bad("==, !=, <, <=, > or >=", m_at);
            step.Op = s_ops[op];
            step.Right = Operand(out string right);
            Add(step, left, right);
        }

        FilterOperand Operand(out string name)
        {
            SkipSpace();
            int from = m_at;
            name = null;
            if (m_at < Text.Length && (char.IsLetter(Text[m_at]) || Text[m_at] == '_'))
            {
                while (m_at < Text.Length && (char.IsLetterOrDigit(Text[m_at]) || Text[m_at] == '_'))
                    m_at++;
                name = Text.Substring(from, m_at - from);
                return new FilterOperand { IsAttribute = true };
            }
            if (m_at < Text.Length && Text[m_at] == '"')
            {
                int end = Text.IndexOf('"', m_at + 1);
                if (end < 0)
                    throw Bad("a name that ends in \"", from);
                name = Text.Substring(from + 1, end - from - 1);
                m_at = end + 1;
                return new FilterOperand { IsAttribute = true };
            }
            while (m_at < Text.Length && (char.IsLetterOrDigit(Text[m_at]) || Text[m_at] == '.' ||
                (Text[m_at] == '-' || Text[m_at] == '+') && (m_at == from || char.ToLowerInvariant(Text[m_at - 1]) == 'e')))
                m_at++;
            if (m_at == from || !NumberText.TryRead(Text.Substring(from, m_at - from), out double number))
                throw Bad("an attribute or a number", from);
            return new FilterOperand { Number = number };
        }

        void Add(in FilterStep step, string left, string right)
        {
            if (Steps.Count == MaxSteps)
                throw Bad("at most " + MaxSteps + " comparisons and joints", m_at);
            Steps.Add(step);
            Names.Add((left, right));
        }

        void SkipSpace()
        {
            while (m_at < Text.Length && char.IsWhiteSpace(Text[m_at]))
                m_at++;
        }

        bool Take(string token)
        {
            SkipSpace();
            if (string.CompareOrdinal(Text, m_at, token, 0, token.Length) != 0)
                return false;
            m_at += token.Length;
            return true;
        }

        FormatException Bad(string wanted, int at)
        {
            string got = at < Text.Length ? "'" + Text[at] + "'" : "the end";
            return new FormatException("wanted " + wanted + " at character " + (at + 1) + ", got " + got + "\n  " +
                Text.Replace('\n', ' ').Replace('\r', ' ').Replace('\t', ' ') + "\n  " + new string(' ', at) + "^");
        }
    }
}
