using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    public enum MessageType
    {
        None = 0,
        Info = 1,
        Warning = 2,
        Error = 3,
    }

    /// <summary>There is no window: nothing is shown, and every value stays as it is.</summary>
    public sealed class EditorGUI
    {
        public static void BeginChangeCheck()
        {
        }

        public static bool EndChangeCheck() => false;
    }

    public sealed class EditorGUILayout
    {
        public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options) => false;

        public static void LabelField(string label, string label2, params GUILayoutOption[] options)
        {
        }

        public static void HelpBox(string message, MessageType type)
        {
        }

        public static int IntSlider(string label, int value, int leftValue, int rightValue,
            params GUILayoutOption[] options) => value;

        public static bool Toggle(string label, bool value, params GUILayoutOption[] options) => value;

        public static bool ToggleLeft(string label, bool value, params GUILayoutOption[] options) => value;

        public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick) => true;

        public static string DelayedTextField(string label, string text, params GUILayoutOption[] options) => text;

        public static Enum EnumPopup(string label, Enum selected, params GUILayoutOption[] options) => selected;
    }

    public class EditorUtility
    {
        public static bool DisplayDialog(string title, string message, string ok, string cancel) => false;

        public static string OpenFilePanelWithFilters(string title, string directory, string[] filters) => "";

        public static string OpenFolderPanel(string title, string folder, string defaultName) => "";

        public static void RevealInFinder(string path)
        {
        }

        public static void SetDirty(Object target)
        {
        }
    }

    public static class ObjectFactory
    {
        public static GameObject CreateGameObject(string name, params Type[] types) => new GameObject(name);

        public static T AddComponent<T>(GameObject gameObject) where T : Component => gameObject.AddComponent<T>();
    }

    public sealed class Selection
    {
        public static Object activeObject { get; set; }
    }
}
