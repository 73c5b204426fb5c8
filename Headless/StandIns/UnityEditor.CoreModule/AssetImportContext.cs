using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor.AssetImporters
{
    /// <summary>What an importer said, for tests to look at.</summary>
    public class AssetImportContext
    {
        internal readonly List<string> Errors = new List<string>();
        internal readonly List<string> Warnings = new List<string>();

        internal AssetImportContext(string assetPath)
        {
            this.assetPath = assetPath;
        }

        public string assetPath { get; }

        public Object mainObject { get; private set; }

        public void AddObjectToAsset(string identifier, Object obj) => obj.name = obj.name.Length > 0 ? obj.name : identifier;

        public void SetMainObject(Object obj) => mainObject = obj;

        internal readonly List<string> Dependencies = new List<string>();

        public void DependsOnCustomDependency(string dependency) => Dependencies.Add(dependency);

        public void LogImportError(string msg, Object obj = null) => Errors.Add(msg);

        public void LogImportWarning(string msg, Object obj = null) => Warnings.Add(msg);
    }
}
