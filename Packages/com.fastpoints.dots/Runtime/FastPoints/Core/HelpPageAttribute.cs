using System;
using UnityEngine;

namespace FastPoints.Core
{
    /// <summary>The page of the manual that the question mark of an inspector opens.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    internal sealed class HelpPageAttribute : HelpURLAttribute
    {
        /// <param name="page">Its file's name, without the extension.</param>
        public HelpPageAttribute(string page) : base(page) { }

        /// <summary>Where a page is, where there is an editor.</summary>
        internal static Func<string, string> UrlOf { get; set; }

        public override string URL => UrlOf?.Invoke(base.URL) ?? "";
    }
}
