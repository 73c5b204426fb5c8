using System;
using FastPoints.Entities;
using FastPoints.Gpu;
using FastPoints.Rendering;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>What the package's samples begin with: a scene with Unity's camera and light, settings of point clouds, and the
    /// sample's street.</summary>
    public static class SampleScene
    {
        /// <summary>In the street, which runs along X, looking along it.</summary>
        static readonly Vector3 s_eye = new Vector3(-69, 6, -10);
        static readonly Vector3 s_forward = new Vector3(1, -0.06f, 0);

        /// <summary>Makes the scene in place of those that are open, which the user may save first.</summary>
        /// <param name="fill">Adds what the sample shows.</param>
        public static void Make(Action<PointCloudAsset> fill)
        {
            // The scan takes a while: somebody may play by then.
            if (IsEditing())
                SampleScan.Get(asset =>
                {
                    if (IsEditing() && EditorSceneManager.SaveCurrentModifiedScenesIfUserWantsTo())
                        Make(asset, fill);
                });
        }

        /// <summary>In play mode Unity makes no scenes.</summary>
        static bool IsEditing()
        {
            if (EditorApplication.isPlaying)
                Debug.LogWarning("FastPoints: no scene can be made in play mode: stop it, and choose the sample again");
            return !EditorApplication.isPlaying;
        }

        static void Make(PointCloudAsset asset, Action<PointCloudAsset> fill)
        {
            EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects, NewSceneMode.Single);
            Camera.main.transform.SetPositionAndRotation(s_eye, Quaternion.LookRotation(s_forward));
            var settings = Add<PointCloudSettings>("Point cloud settings");
            settings.Shape = PointShape.Disc;
            settings.SizeMode = PointSizeMode.Adaptive;
            settings.Size = PointSize.DefaultGaps;
            // Where a scanner saw little, points lie far apart: they are not to be drawn as far across.
            settings.MaxSizePx = 8;
            settings.EyeDomeLighting = 0.25f;
            fill(asset);
        }

        /// <summary>A GameObject with one component, as the <em>GameObject</em> menu makes it: Undo takes it away.</summary>
        public static T Add<T>(string name)
            where T : Component => ObjectFactory.AddComponent<T>(ObjectFactory.CreateGameObject(name));
    }
}
