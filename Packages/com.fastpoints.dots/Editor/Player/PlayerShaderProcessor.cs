using System;
using System.Collections.Generic;
using System.IO;
using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEditor.Rendering;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Strips those variants of the package's shaders that nothing in a player needs. Unity asks about shaders when it
    /// builds them, not when it takes them from an earlier build: if that one lacks a variant, the build reports it.</summary>
    internal sealed class PlayerShaderProcessor : BuildPlayerProcessor, IPreprocessShaders, IPostprocessBuildWithReport
    {
        // The state is static because Unity makes an instance for each of the interfaces.
        static PlayerVariants s_wanted;
        static string s_reason;
        static readonly HashSet<string> s_asked = new HashSet<string>();
        static readonly HashSet<string> s_kept = new HashSet<string>();

        public override int callbackOrder => 0;

        public override void PrepareForBuild(BuildPlayerContext buildPlayerContext)
        {
            s_asked.Clear();
            s_kept.Clear();
            s_wanted = new PlayerVariants();
            string[] scenes = PlayerAssets.ScenesOf(buildPlayerContext.BuildPlayerOptions);
            var options = new DrawnOptions { Stereo = PlayerScripts.HasHeadsets };
            s_reason = WhyAll(FastPointsSettings.instance.PlayerVariants);
            if (s_reason != null)
            {
                options.Clipped = options.Filtered = true;
                options.Stereo |= FastPointsSettings.instance.PlayerVariants == VariantChoice.All;
                s_wanted.AddAll(options);
                return;
            }
            var looks = new BuiltLooks();
            looks.Add(scenes, PlayerAssets.Of(scenes));
            (options.Clipped, options.Filtered) = (looks.Clips, looks.Filters);
            foreach (var style in looks.Styles)
                s_wanted.Add(style, options);
            s_reason = "as the built scenes draw points";
        }

        public void OnProcessShader(Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data)
        {
            if (s_wanted == null || !BuildPipeline.isBuildingPlayer ||
                !shader.name.StartsWith(PlayerVariants.ShaderPrefix, StringComparison.Ordinal))
                return;
            if (s_asked.Count == 0)
                s_wanted.Write(EarlierPath);
            var keywords = shader.keywordSpace.keywords;
            var enabled = new List<string>();
            for (int i = data.Count - 1; i >= 0; i--)
            {
                enabled.Clear();
                foreach (var keyword in keywords)
                    if (data[i].shaderKeywordSet.IsEnabled(keyword))
                        enabled.Add(keyword.name);
                string name = PlayerVariants.NameOf(snippet.passName, enabled);
                s_asked.Add(name);
                if (s_wanted.Contains(name))
                    s_kept.Add(name);
                else
                    data.RemoveAt(i);
            }
        }

        public void OnPostprocessBuild(BuildReport report)
        {
            var wanted = s_wanted;
            s_wanted = null;
            if (wanted == null)
                return;
            if (s_asked.Count > 0)
                Debug.Log("FastPoints: " + s_kept.Count + " of " + s_asked.Count + " variants of the point shaders: " + s_reason);
            else if (PlayerVariants.Read(EarlierPath) is { } earlier && !wanted.IsWithin(earlier))
                Debug.LogError("FastPoints: Unity took the shaders of an earlier build, which lack variants that the scenes " +
                    "need by now: points may be drawn as single pixels. Build with Clean Build.");
        }

        /// <summary>The variants of the build in which Unity built the shaders: one file a platform, like Unity's own
        /// cache.</summary>
        static string EarlierPath => Path.Combine(PointCloudImports.Paths.Absolute("Library/FastPoints"),
            "ShaderVariants-" + EditorUserBuildSettings.activeBuildTarget + ".txt");

        /// <summary>The reason for people; null if the scenes decide.</summary>
        static string WhyAll(VariantChoice choice)
        {
            if (choice == VariantChoice.BuiltScenes)
                return null;
            if (choice == VariantChoice.All)
                return "all, as the project settings say";
            if (AssetDatabase.GetAllAssetBundleNames().Length > 0 ||
                Directory.Exists(PointCloudImports.Paths.Absolute("Assets/AddressableAssetsData")))
                return "all, for there may be scenes in asset bundles or Addressables";
            string script = PlayerScripts.FindChanger();
            return script != null ? "all, for " + script + " may change what points look like" : null;
        }
    }

    /// <summary>Which variants of the package's shaders go into players.</summary>
    internal enum VariantChoice
    {
        /// <summary>Those that the built scenes need; all of them if scripts, asset bundles or Addressables may need
        /// others.</summary>
        Automatic,

        /// <summary>Those that the built scenes need, whatever scripts may request.</summary>
        BuiltScenes,

        All,
    }
}
