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
    /// builds them, not when it takes them from an earlier build: if that one lacked a variant, a build fails before it
    /// begins.</summary>
    internal sealed class PlayerShaderProcessor : BuildPlayerProcessor, IPreprocessShaders, IPostprocessBuildWithReport
    {
        // The state is static because Unity makes an instance for each of the interfaces.
        static PlayerVariants s_wanted;
        static string s_reason;
        static string s_path;
        static readonly HashSet<string> s_asked = new HashSet<string>();
        static readonly HashSet<string> s_kept = new HashSet<string>();

        public override int callbackOrder => 0;

        public override void PrepareForBuild(BuildPlayerContext buildPlayerContext)
        {
            s_asked.Clear();
            s_kept.Clear();
            s_wanted = null;
            var player = buildPlayerContext.BuildPlayerOptions;
            var wanted = WantedBy(PlayerAssets.ScenesOf(player));
            s_path = Path.Combine(PointCloudImports.Paths.Absolute("Library/FastPoints"),
                "ShaderVariants-" + player.target + ".txt");
            if ((player.options & BuildOptions.CleanBuildCache) == 0 && PlayerVariants.Read(s_path) is { } earlier &&
                !wanted.IsWithin(earlier))
                throw new BuildFailedException("FastPoints: Unity may take the point shaders of the last build for " +
                    player.target + ", which lack variants that this one needs (" + s_reason + "). Build once with Clean Build " +
                    "(BuildOptions.CleanBuildCache)");
            s_wanted = wanted;
        }

        static PlayerVariants WantedBy(string[] scenes)
        {
            var wanted = new PlayerVariants();
            var choice = FastPointsSettings.instance.PlayerVariants;
            var options = new DrawnOptions { Stereo = PlayerScripts.HasHeadsets };
            var looks = new BuiltLooks();
            s_reason = WhyAll(choice);
            if (s_reason == null)
            {
                looks.Add(scenes, PlayerAssets.Of(scenes));
                if (looks.Changer != null && choice == VariantChoice.Automatic)
                    s_reason = "all, for " + looks.Changer + " has an event or animation that may change what points look like";
            }
            if (s_reason != null)
            {
                options.Clipped = options.Filtered = true;
                options.Stereo |= choice == VariantChoice.All;
                wanted.AddAll(options);
                return wanted;
            }
            (options.Clipped, options.Filtered) = (looks.Clips, looks.Filters);
            foreach (var style in looks.Styles)
                wanted.Add(style, options);
            s_reason = "as the built scenes draw points";
            return wanted;
        }

        public void OnProcessShader(Shader shader, ShaderSnippetData snippet, IList<ShaderCompilerData> data)
        {
            if (s_wanted == null || !BuildPipeline.isBuildingPlayer ||
                !shader.name.StartsWith(PlayerVariants.ShaderPrefix, StringComparison.Ordinal))
                return;
            if (s_asked.Count == 0)
                s_wanted.Write(s_path);
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
            if (s_wanted != null && s_asked.Count > 0)
                Debug.Log("FastPoints: " + s_kept.Count + " of " + s_asked.Count + " variants of the point shaders: " + s_reason);
            s_wanted = null;
        }

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
        /// <summary>Those that the built scenes need; all of them if scripts, events, animations, asset bundles or Addressables
        /// may need others.</summary>
        Automatic,

        /// <summary>Those that the built scenes need, whatever scripts may request.</summary>
        BuiltScenes,

        All,
    }
}
