using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace FastPoints.Projects.Urp
{
    /// <summary>Makes this a project of URP by itself, in linear colour: without an asset that the settings name, Unity would
    /// draw with the Built-in pipeline.</summary>
    sealed class ProjectSetup : AssetPostprocessor
    {
        const string Path = "Assets/UrpPipeline.asset";

        static bool s_isMaking;

        /// <summary>Also when the project is opened: before that, assets may not be touched.</summary>
        static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets,
            string[] movedFromAssetPaths, bool didDomainReload)
        {
            if (PlayerSettings.colorSpace != ColorSpace.Linear)
                PlayerSettings.colorSpace = ColorSpace.Linear;
            // Making the asset may come back here.
            if (s_isMaking || GraphicsSettings.defaultRenderPipeline != null)
                return;
            s_isMaking = true;
            var pipeline = AssetDatabase.LoadAssetAtPath<UniversalRenderPipelineAsset>(Path);
            GraphicsSettings.defaultRenderPipeline = pipeline != null ? pipeline : Make();
            AssetDatabase.SaveAssets();
            s_isMaking = false;
        }

        static UniversalRenderPipelineAsset Make()
        {
            var pipeline = UniversalRenderPipelineAsset.Create();
            AssetDatabase.CreateAsset(pipeline, Path);
            // An asset of its own, with all that it needs.
            pipeline.LoadBuiltinRendererData();
            return pipeline;
        }
    }
}
