using System;
using System.Globalization;
using System.IO;
using System.Reflection;
using FastPoints.Build;
using FastPoints.Entities;
using FastPoints.Nodes;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>A project's settings for imports: in <c>ProjectSettings/FastPoints.asset</c>, for version control.</summary>
    [FilePath(FileName, FilePathAttribute.Location.ProjectFolder)]
    internal sealed class FastPointsSettings : ScriptableSingleton<FastPointsSettings>
    {
        const string FileName = "ProjectSettings/FastPoints.asset";

        public Sampler Sampler = Sampler.Poisson;

        public bool Normals;

        /// <summary>Where converted clouds are kept: relative to the project, or an absolute path. Clouds elsewhere stay there
        /// and are found where their handles say.</summary>
        public string Place = ProjectPaths.DefaultClouds;

        public bool GitIgnore = true;

        /// <summary>Limit for everything in a conversion that grows with the number of points; the rest goes to files.</summary>
        public int MemoryMiB = 1024;
        public int Workers; // The most workers of the job system that a conversion keeps busy; 0 for all.

        public InPlayMode InPlayMode;
        public int UpdateMs = 4; // Main-thread time that a conversion gets in each update of the editor.

        /// <summary>Graphics memory for points in the editor if a scene has no <see cref="PointCloudSettings"/>; new ones begin
        /// with it.</summary>
        public int GpuMiB = 512;
        public int MaxCopiedMiB = 64; // Larger files are not copied into the project when dropped: they get a handle.

        public PointFiles PointFiles; // How to handle point cloud files in Assets that no other package imports.

        public SeveralFiles SeveralFiles;

        public bool ConvertAtOnce = true;
        public bool ConvertOctrees; // Whether that includes COPC, Potree and EPT, which can be streamed directly.
        public int PlayerWarningMiB = 2048; // A build warns if a player's clouds are larger; 0 for never.

        /// <summary>Assets of clouds that go into every player, because only code names them: by GUID, since settings are loaded
        /// before assets are imported, and a reference would then be null.</summary>
        public string[] AlwaysInPlayers = new string[0];

        /// <summary>Whether the shaders of pictures over several frames (<see cref="Rendering.PointStyle.PointsPerFrame"/>) are
        /// built into players.</summary>
        public bool ProgressiveInPlayers = true;

        /// <summary><see cref="Place"/> as stored, for code that must not load the settings.</summary>
        /// <param name="project">The project's folder.</param>
        public static ProjectPaths ReadPaths(string project)
        {
            string file = Path.Combine(project, FileName), key = nameof(Place) + ":";
            string line = File.Exists(file) ? Array.Find(File.ReadAllLines(file), l => l.TrimStart().StartsWith(key,
                StringComparison.Ordinal)) : null;
            string folder = line?.Substring(line.IndexOf(':') + 1).Trim().Trim('\'', '"');
            return string.IsNullOrEmpty(folder) ? new ProjectPaths(project) : new ProjectPaths(project, folder);
        }

        string m_saved; // What the file says; kept when scripts are reloaded, as Unity keeps private fields.
        string m_refused; // The text that could not be saved, which was reported.

        void OnEnable()
        {
            if (string.IsNullOrEmpty(m_saved))
                m_saved = Text();
        }

        /// <summary>All that is kept, to compare within a session.</summary>
        string Text() => string.Join("\n", Array.ConvertAll(GetType().GetFields(BindingFlags.Instance | BindingFlags.Public), f =>
            f.GetValue(this) is string[] texts ? string.Join(",", texts)
                : System.Convert.ToString(f.GetValue(this), CultureInfo.InvariantCulture)));

        /// <summary>Applies changes, and saves them. Every Undo calls this, and a changed file would rebuild all of a
        /// player's data.</summary>
        public void Save()
        {
            Apply();
            string now = Text();
            if (now == m_saved && File.Exists(FileName))
                return;
            // Each Undo and each step of a slider would ask version control again, and report it again.
            if (now == m_refused && File.Exists(FileName) && (File.GetAttributes(FileName) & FileAttributes.ReadOnly) != 0)
                return;
            try
            {
                VersionedFile.CheckOut(FileName);
                Save(true);
                (m_saved, m_refused) = (now, null);
            }
            catch (PointCloudException e)
            {
                m_refused = now;
                Debug.LogError("FastPoints: the settings hold until the editor is closed, and are saved with the next change. " +
                    e.Message);
            }
        }

        public void Apply()
        {
            PointCloudPaths.ConvertedRoot = Place;
            PointCloudPaths.SourceRoot = FastPointsUserSettings.EffectiveSourceRoot;
            PointCloudSystemGroup.DefaultPoolBytes = (long)GpuMiB << 20;
            EditorApplication.QueuePlayerLoopUpdate();
        }

        public ConvertSettings ForConversion(ImportRequest request) => new ConvertSettings
        {
            Sampler = request.Sampler,
            MemoryBytes = (long)MemoryMiB << 20,
            Workers = Workers,
            // Shorter conversions are not worth the files: a reload loses about as much again while nodes are built.
            SecondsInMemory = 15,
        };
    }

    internal enum InPlayMode
    {
        OneWorker, // They leave the other workers to the game.
        Pause, // They resume when play mode ends.
        AsInEditMode,
    }
}
