using System;
using System.IO;
using FastPoints.Editor;
using FastPoints.Entities;
using FastPoints.Feeds;
using FastPoints.HostTests.Cli;
using FastPoints.Pipeline;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;

namespace FastPoints.HostTests.Editor
{
    /// <summary>A project's folder as an editor has it open: it is the current one, and files in <c>Assets</c> are imported by
    /// the package's importers.</summary>
    sealed class EditorProject : IDisposable
    {
        readonly string m_before = Environment.CurrentDirectory;

        public EditorProject()
        {
            Directory.CreateDirectory(Scratch["project/Assets"]);
            Environment.CurrentDirectory = Scratch["project"];
            Application.AssetsPath = Scratch["project/Assets"];
            AssetDatabase.Importing = Import;
            Paths = new ProjectPaths(Scratch["project"]);
            PointFileReaders.Register();
            Imports = new EditorImports(Paths, FastPointsSettings.instance);
        }

        public ScratchFolder Scratch { get; } = new ScratchFolder();
        public ProjectPaths Paths { get; }
        public EditorImports Imports { get; private set; }

        /// <summary>What a user has set in an importer's inspector; null for nothing.</summary>
        public Action<CloudImporter> SetImporter { get; set; }

        /// <summary>What the last import said.</summary>
        public AssetImportContext LastImport { get; private set; }

        /// <summary>A file that is COPC by its name: nobody opens it.</summary>
        public string Copc(string name)
        {
            File.WriteAllText(Scratch[name], "LASF");
            return Scratch[name];
        }

        public PointCloudAsset Asset(string path) => AssetDatabase.LoadAssetAtPath<PointCloudAsset>(path);

        /// <summary>Updates of the editor until nothing is to be converted.</summary>
        public void UpdateToTheEnd()
        {
            var now = DateTime.UtcNow;
            ImportProject.Updates(() =>
            {
                now = now.AddSeconds(0.3);
                Imports.Update(now);
            }, () => Imports.Queue.Requests.Count == 0);
        }

        public void Import(string path)
        {
            CloudImporter importer = path.EndsWith(CloudHandle.Extension) ? new HandleImporter() : new PointFileImporter();
            SetImporter?.Invoke(importer);
            LastImport = new AssetImportContext(path);
            importer.OnImportAsset(LastImport);
            var made = (PointCloudAsset)LastImport.mainObject;
            // Who refers to it goes on doing so.
            if (Asset(path) is { } before)
            {
                (before.ProjectPath, before.PlayerPath, before.Points, before.BoundsMin, before.BoundsMax, before.Crs) =
                    (made.ProjectPath, made.PlayerPath, made.Points, made.BoundsMin, made.BoundsMax, made.Crs);
                (before.ProjectSources, before.PlayerSource, before.HasOrigin, before.Origin) =
                    (made.ProjectSources, made.PlayerSource, made.HasOrigin, made.Origin);
                (before.Up, before.UnitMetres) = (made.Up, made.UnitMetres);
            }
            else
                AssetDatabase.Assets[path] = made;
        }

        public void Dispose()
        {
            Imports.Dispose();
            // What PointCloudImports holds is this project's.
            AssemblyReloadEvents.Reload();
            AssetDatabase.Assets.Clear();
            AssetDatabase.Overrides.Clear();
            AssetDatabase.Importers.Clear();
            AssetDatabase.Dependencies.Clear();
            AssetDatabase.Importing = null;
            Progress.Entries.Clear();
            DragAndDrop.paths = Array.Empty<string>();
            DragAndDrop.objectReferences = Array.Empty<UnityEngine.Object>();
            Application.AssetsPath = null;
            CloudFeeds.Register(null);
            Environment.CurrentDirectory = m_before;
            Scratch.Dispose();
        }
    }
}
