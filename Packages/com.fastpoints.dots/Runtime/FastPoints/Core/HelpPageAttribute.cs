using System;
using UnityEngine;

namespace FastPoints.Core
{
    // The page of the manual, by its file's name without the extension, that the question mark of an inspector opens.
    [AttributeUsage(AttributeTargets.Class)]
    internal sealed class HelpPageAttribute : HelpURLAttribute
    {
        public HelpPageAttribute(string page) : base(page) { }

        // Null where there is no editor.
        internal static Func<string, string> UrlOf { get; set; }

        public override string URL => UrlOf?.Invoke(base.URL) ?? "";
    }
}
