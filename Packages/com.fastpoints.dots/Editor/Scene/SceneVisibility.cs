using FastPoints.Entities;
using FastPoints.Rendering;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Has clouds shown where the editor shows other objects: in prefab stages and isolated scenes, and not where the
    /// eye in the hierarchy is closed.</summary>
    [InitializeOnLoad]
    internal static class SceneVisibility
    {
        static SceneVisibility()
        {
            if (AssetDatabase.IsAssetImportWorkerProcess())
                return;
            CameraViews.SceneMaskOf = MaskOf;
            PointCloud.IsHiddenInSceneViews = cloud => SceneVisibilityManager.instance.IsHidden(cloud);
            PointCloudOrigin.Decided = RecordChanges;
            // Clouds check it in their updates.
            SceneVisibilityManager.visibilityChanged += EditModeFrames.RequestFrame;
        }

        /// <summary>Saves changes that were not made by the user, in instances of prefabs too.</summary>
        static void RecordChanges(PointCloudOrigin origin)
        {
            if (EditorApplication.isPlaying)
                return;
            EditorUtility.SetDirty(origin);
            PrefabUtility.RecordPrefabInstancePropertyModifications(origin);
        }

        /// <summary>In the form that the render pipelines use.</summary>
        static ulong MaskOf(Camera camera)
        {
            if (camera.overrideSceneCullingMask != 0)
                return camera.overrideSceneCullingMask;
            if (camera.scene.IsValid())
                return EditorSceneManager.GetSceneCullingMask(camera.scene);
            return camera.cameraType == CameraType.SceneView ? SceneCullingMasks.MainStageSceneViewObjects
                : SceneCullingMasks.GameViewObjects;
        }
    }
}
