using System;
using UnityEngine;

namespace FastPoints
{
    // Marks a struct that lies on disk as in memory: a check keeps it equal to its table in internals/disk-format.md.
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class DiskFormatAttribute : Attribute { }

    // Marks a struct that shaders read as it lies in memory: a check keeps it equal to its twin in Shaders/Generated.
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class GenerateHlslAttribute : Attribute { }

    // The page of the manual, by its file's name without the extension, that the question mark of an inspector opens.
    [AttributeUsage(AttributeTargets.Class)]
    internal sealed class HelpPageAttribute : HelpURLAttribute
    {
        public HelpPageAttribute(string page) : base(page) { }

        // Null if there is no editor.
        internal static Func<string, string> UrlOf { get; set; }

        public override string URL => UrlOf?.Invoke(base.URL) ?? "";
    }
}
