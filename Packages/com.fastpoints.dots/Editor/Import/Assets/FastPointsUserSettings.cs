using System;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>Settings of this user or machine, not under version control.</summary>
    [FilePath("UserSettings/FastPoints.asset", FilePathAttribute.Location.ProjectFolder)]
    internal sealed class FastPointsUserSettings : ScriptableSingleton<FastPointsUserSettings>
    {
        /// <summary>An environment variable that overrides <see cref="SourceRoot"/>, for build servers.</summary>
        public const string Variable = "FASTPOINTS_SOURCES";
        public string SourceRoot = ""; // The folder below which this user has what the team's clouds are made of; empty for none.

        public static string EffectiveSourceRoot =>
            Environment.GetEnvironmentVariable(Variable) is { Length: > 0 } root ? root : instance.SourceRoot;

        public void SetRoot(string root)
        {
            SourceRoot = root;
            Save(true);
        }
    }
}
