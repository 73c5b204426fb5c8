using System;
using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Editor
{
    /// <summary>The list of classes in an inspector, and the effect of switching one.</summary>
    internal static class ClassFilter
    {
        /// <summary>The classes that a cloud may have: all defined ones from its smallest to its largest, and those that are
        /// hidden already.</summary>
        /// <param name="min">Minimum of its classification; NaN if unknown, as is <paramref name="max"/>.</param>
        public static List<int> ClassesOf(double min, double max, int[] hidden)
        {
            bool isKnown = min <= max;
            var classes = new List<int>();
            for (int c = 0; c <= byte.MaxValue; c++)
            {
                bool isPossible = isKnown ? c >= min && c <= max : c < ClassNames.FirstUserDefined;
                bool isMeant = ClassNames.Of(c) != null ||
                    (isKnown && (c == min || c == max || c >= ClassNames.FirstUserDefined));
                if ((isPossible && isMeant) || Array.IndexOf(hidden, c) >= 0)
                    classes.Add(c);
            }
            return classes;
        }

        /// <summary>The label of a class: "2 ground".</summary>
        public static string Label(int c) => NumberText.Of(c) + " " +
            (ClassNames.Of(c) ?? (c < ClassNames.FirstUserDefined ? "reserved" : "of the user"));

        /// <summary>The hidden classes after one was switched, rising; the same array if nothing changes.</summary>
        public static int[] Switch(int[] hidden, int c, bool isShown)
        {
            if (Array.IndexOf(hidden, c) >= 0 == !isShown)
                return hidden;
            var classes = new List<int>(hidden);
            if (isShown)
                classes.RemoveAll(h => h == c);
            else
                classes.Add(c);
            classes.Sort();
            return classes.ToArray();
        }
    }
}
