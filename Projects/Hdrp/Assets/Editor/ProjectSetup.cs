using System;
using System.Reflection;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.HighDefinition;

namespace FastPoints.Projects.Hdrp
{
    /// <summary>Makes this a project of HDRP by itself, in linear colour and without its wizard: without an asset that the
    /// settings name, Unity would draw with the Built-in pipeline.</summary>
    sealed class ProjectSetup : AssetPostprocessor
    {
        const string Path = "Assets/HdrpPipeline.asset";

        const string WizardSettings =
            "UnityEditor.Rendering.HighDefinition.HDUserSettings, Unity.RenderPipelines.HighDefinition.Editor";

        static bool s_isMaking;

        /// <summary>Also when the project is opened: before that, assets may not be touched.</summary>
        static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets,
            string[] movedFromAssetPaths, bool didDomainReload)
        {
            if (PlayerSettings.colorSpace != ColorSpace.Linear)
                PlayerSettings.colorSpace = ColorSpace.Linear;
            CloseWizard();
            // Making the asset may come back here.
            if (s_isMaking || GraphicsSettings.defaultRenderPipeline != null)
                return;
            s_isMaking = true;
            var pipeline = AssetDatabase.LoadAssetAtPath<HDRenderPipelineAsset>(Path);
            GraphicsSettings.defaultRenderPipeline = pipeline != null ? pipeline : Make();
            AssetDatabase.SaveAssets();
            s_isMaking = false;
        }

        static HDRenderPipelineAsset Make()
        {
            var pipeline = ScriptableObject.CreateInstance<HDRenderPipelineAsset>();
            AssetDatabase.CreateAsset(pipeline, Path);
            return pipeline;
        }

        /// <summary>It would open over the Test Runner. Its setting has no public way.</summary>
        static void CloseWizard()
        {
            const BindingFlags any = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;
            var opens = Type.GetType(WizardSettings)?.GetProperty("wizardIsStartPopup", any);
            if (opens != null && (bool)opens.GetValue(null))
                opens.SetValue(null, false);
        }
    }
}
