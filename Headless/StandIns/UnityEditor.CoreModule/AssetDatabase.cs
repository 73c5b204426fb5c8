using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    [Flags]
    public enum ImportAssetOptions
    {
        Default = 0,
        ForceUpdate = 1,
    }

    public class AssetImporter : Object
    {
        internal string Path;

        public string assetPath => Path;

        public static AssetImporter GetAtPath(string path) =>
            AssetDatabase.Assets.ContainsKey(path) ? new AssetImporter { Path = path } : null;

        public void SaveAndReimport() => AssetDatabase.ImportAsset(Path);
    }

    public class AssetPostprocessor
    {
    }

    /// <summary>Assets by path, as a test puts them there.</summary>
    public sealed class AssetDatabase
    {
        internal static readonly Dictionary<string, Object> Assets = new Dictionary<string, Object>();
        internal static readonly Dictionary<string, Type> Importers = new Dictionary<string, Type>();
        internal static readonly Dictionary<string, Type> Overrides = new Dictionary<string, Type>();
        internal static readonly Dictionary<string, string[]> Dependencies = new Dictionary<string, string[]>();

        internal static readonly Dictionary<string, Hash128> CustomDependencies = new Dictionary<string, Hash128>();

        /// <summary>What a host does where Unity would run the importer of an asset's type.</summary>
        internal static Action<string> Importing;

        /// <summary>An asset's path is what is hashed: it keeps its number as long as it is not moved.</summary>
        public static string AssetPathToGUID(string path) => GuidOf(path);

        public static string GUIDToAssetPath(string guid) => Assets.Keys.FirstOrDefault(p => GuidOf(p) == guid) ?? "";

        public static string GetAssetPath(Object assetObject) =>
            Assets.FirstOrDefault(a => ReferenceEquals(a.Value, assetObject)).Key ?? "";

        public static T LoadAssetAtPath<T>(string assetPath) where T : Object =>
            Assets.TryGetValue(assetPath, out var asset) ? asset as T : null;

        public static void ImportAsset(string path) => ImportAsset(path, ImportAssetOptions.Default);

        public static void ImportAsset(string path, ImportAssetOptions options) => Importing?.Invoke(path);

        public static void RegisterCustomDependency(string dependency, Hash128 hashOfValue) =>
            CustomDependencies[dependency] = hashOfValue;

        /// <summary>Of a filter by type, as <c>t:Name</c>, and of no other.</summary>
        public static string[] FindAssets(string filter) =>
            Assets.Where(a => "t:" + KindOf(a.Value) == filter).Select(a => GuidOf(a.Key)).ToArray();

        static string KindOf(Object asset) => asset is GameObject ? "Prefab" : asset.GetType().Name;

        internal static readonly List<string> AssetBundleNames = new List<string>();

        public static string[] GetAllAssetBundleNames() => AssetBundleNames.ToArray();

        public static string[] FindAssets(string filter, string[] searchInFolders) =>
            throw EditorOnly.NotHere(nameof(FindAssets) + " in folders");

        public static string CreateFolder(string parentFolder, string newFolderName) => throw EditorOnly.NotHere(nameof(CreateFolder));

        public static bool DeleteAsset(string path) => throw EditorOnly.NotHere(nameof(DeleteAsset));

        public static void Refresh() => throw EditorOnly.NotHere(nameof(Refresh));

        public static bool IsValidFolder(string path) => System.IO.Directory.Exists(path);

        public static string[] GetDependencies(string[] pathNames, bool recursive) =>
            pathNames.SelectMany(p => Dependencies.TryGetValue(p, out var of) ? of : new string[0]).Concat(pathNames).Distinct()
                .ToArray();

        public static Type GetImporterOverride(string path) => Overrides.TryGetValue(path, out var type) ? type : null;

        public static Type GetDefaultImporter(string path) =>
            Importers.TryGetValue(path, out var type) ? type : typeof(AssetImporter);

        public static Type GetImporterType(string assetPath) => GetImporterOverride(assetPath) ?? GetDefaultImporter(assetPath);

        public static void SetImporterOverride<T>(string path) where T : AssetImporter => Overrides[path] = typeof(T);

        public static bool IsAssetImportWorkerProcess() => false;

        static string GuidOf(string path)
        {
            ulong hash = 14695981039346656037;
            foreach (char c in path)
                hash = (hash ^ c) * 1099511628211;
            return hash.ToString("x16") + (~hash).ToString("x16");
        }
    }
}
